// SPDX-License-Identifier: Apache-2.0
// Which policy to use, when parameters were fitted several times.
#include <algorithm>
#include <set>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

using Round = std::vector<const Group*>;

/// The fit that each run of the group took.
std::vector<int> fits_of(const Group& group, int fits) {
  std::vector<int> numbers;
  for (const int index : group.indices) numbers.push_back(fit_of(index, fits));
  return numbers;
}

Estimate cost_of(const Group& group, int fits) {
  return estimate_over_groups(group.metric(Metric::user_cost), fits_of(group, fits));
}

Estimate difference(const Group& a, const Group& b, int fits) {
  std::vector<double> values = a.metric(Metric::user_cost);
  const std::vector<double> others = b.metric(Metric::user_cost);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= others[i];
  return estimate_over_groups(values, fits_of(a, fits));
}

/// Rounds in which several policies have a cost.
std::vector<Round> rounds_with_cost(const Results& results) {
  std::vector<Round> all;
  for (const char* kind : {"thesis", "comparison"}) {
    for (const RunSet* set : sets_of(results, kind)) {
      for (Round& round : rounds_of(results.groups, set->name)) {
        if (round.size() > 1 && best_of(round, Metric::user_cost) != nullptr) {
          all.push_back(std::move(round));
        }
      }
    }
  }
  return all;
}

void add_table(const Round& round, int fits, Document& document) {
  const Group& best = *best_of(round, Metric::user_cost);
  std::vector<std::vector<std::string>> rows{{"policy", "cost over fits"}};
  for (int fit = 1; fit <= fits; ++fit) rows[0].push_back("fit " + std::to_string(fit));
  rows[0].push_back("minus " + display_name(best.policy));
  for (const Group* group : round) {
    std::vector<std::string> row{display_name(group->policy), html::number(cost_of(*group, fits))};
    const std::vector<double> costs = group->metric(Metric::user_cost);
    const std::vector<int> numbers = fits_of(*group, fits);
    for (int fit = 1; fit <= fits; ++fit) {
      std::vector<double> own;
      for (std::size_t i = 0; i < costs.size(); ++i) {
        if (numbers[i] == fit) own.push_back(costs[i]);
      }
      row.push_back(html::number(estimate(own).mean));
    }
    row.push_back(group == &best ? "" : html::number(difference(*group, best, fits)));
    rows.push_back(std::move(row));
  }
  document.table(rows);
}

/// Whether every other policy costs more than `best`, with 95 % confidence over fits.
bool is_clear(const Round& round, const Group& best, int fits) {
  return std::all_of(round.begin(), round.end(), [&](const Group* group) {
    return group == &best || difference(*group, best, fits).above(0);
  });
}

std::string sentence(const std::vector<Round>& rounds, int fits) {
  std::set<std::string> winners;
  std::string list;
  std::size_t clear = 0;
  for (const Round& round : rounds) {
    const Group& best = *best_of(round, Metric::user_cost);
    const bool sure = is_clear(round, best, fits);
    winners.insert(best.policy);
    clear += sure;
    list += (list.empty() ? "" : "; ") + best.set + ", " + round_title(best) + ": " +
            display_name(best.policy) + (sure ? "" : ", not told apart from all others");
  }
  const std::string over = "over " + std::to_string(fits) + " fits ";
  if (winners.size() > 1) return "No policy is the best everywhere " + over + "(" + list + ").";
  return "Use " + display_name(*winners.begin()) + ": " + over + "it costs users least in all " +
         std::to_string(rounds.size()) + " rounds, and less than every other policy with 95 % " +
         "confidence in " + std::to_string(clear) + " of them.";
}

}  // namespace

void add_recommendation(const Results& results, Document& document) {
  const int fits = results.experiment.timing.fits;
  const std::vector<Round> rounds = rounds_with_cost(results);
  if (fits < 2 || rounds.empty()) return;
  document.heading(2, "Which policy to use");
  document.paragraph("<strong>" + sentence(rounds, fits) + "</strong>");
  document.paragraph(
      "Every policy's parameters were fitted " + std::to_string(fits) +
      " times, each time to other runs, and each evaluated run took one of the fits in turn. The "
      "interval is over fits, so that it holds their chance and that of the runs.");
  for (const Round& round : rounds) {
    document.heading(3, round.front()->set + ": " + round_title(*round.front()));
    add_table(round, fits, document);
  }
}

}  // namespace tocsin::experiment
