// SPDX-License-Identifier: Apache-2.0
// One cost for speaking and silence alike, and which policy is best at what.
#include <algorithm>
#include <cmath>

#include "foundation/parameters.hpp"
#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<Metric> contested{
    Metric::user_cost,         Metric::critical_late,    Metric::high_late,
    Metric::critical_lost,     Metric::low_delivered,    Metric::location_age_p99,
    Metric::telemetry_per_max, Metric::high_latency_p99, Metric::probe_per_max};

/// What the cost is made of, besides the cost itself.
const std::vector<Metric> figures{Metric::critical_late,       Metric::critical_very_late,
                                  Metric::high_late,           Metric::high_very_late,
                                  Metric::low_delivered,       Metric::location_age_p99,
                                  Metric::picture_latency_p99, Metric::airtime};

const Group* ours_of(const std::vector<const Group*>& round) {
  const auto found = std::find_if(round.begin(), round.end(),
                                  [](const Group* group) { return group->policy == "tocp_dsp"; });
  return found == round.end() ? nullptr : *found;
}

/// The rounds in which several policies with TOCP-DSP among them were driven.
std::vector<std::vector<const Group*>> contests(const Results& results) {
  std::vector<std::vector<const Group*>> all;
  for (const char* kind : {"thesis", "comparison"}) {
    for (const RunSet* set : sets_of(results, kind)) {
      for (auto& round : rounds_of(results.groups, set->name)) {
        if (ours_of(round) != nullptr && round.size() > 1) all.push_back(std::move(round));
      }
    }
  }
  return all;
}

std::string coloured(const Estimate& difference, bool less_is_better) {
  const Verdict verdict = judge(difference, less_is_better);
  const char* kind = verdict == Verdict::better ? "yes" : verdict == Verdict::worse ? "no" : "open";
  return std::string("<span class=\"") + kind + "\">" + html::number(difference) + "</span>";
}

void add_cost_table(const std::vector<const Group*>& round, Document& document) {
  auto ranked = round;
  const auto cost = [](const Group* group) {
    return estimate(group->metric(Metric::user_cost)).mean;
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&](const Group* a, const Group* b) { return cost(a) < cost(b); });
  std::vector<std::vector<std::string>> rows{{"policy", "cost", "TOCP-DSP minus this"}};
  for (const Metric metric : figures) rows[0].push_back(metric_label(metric));
  const Group& ours = *ours_of(round);
  for (const Group* group : ranked) {
    const Estimate difference =
        paired_difference(ours.metric(Metric::user_cost), group->metric(Metric::user_cost));
    std::vector<std::string> row{display_name(group->policy),
                                 html::number(estimate(group->metric(Metric::user_cost))),
                                 group == &ours ? "" : coloured(difference, true)};
    for (const Metric metric : figures) {
      row.push_back(html::number(estimate(group->metric(metric))));
    }
    rows.push_back(std::move(row));
  }
  document.table(rows);
}

void add_cost_figure(const std::vector<const Group*>& round, Document& document) {
  Figure figure("cost_" + round_id(*round.front()),
                mission_name(round.front()->mission) + ": cost of what users feel");
  figure.axes("", "cost [% of class low]").with("set yrange [0:*]");
  for (const Group* group : round) {
    const Estimate one = estimate(group->metric(Metric::user_cost));
    figure.interval(display_name(group->policy), one.mean, one.low, one.high);
  }
  document.figure(std::move(figure), "Mean over runs with its 95 % interval; lower is better.");
}

void add_best_table(const std::vector<std::vector<const Group*>>& rounds, Document& document) {
  std::vector<std::vector<std::string>> rows{
      {"set and round", "metric", "best mean", "its policy", "TOCP-DSP", "TOCP-DSP minus best"}};
  for (const auto& round : rounds) {
    const Group& ours = *ours_of(round);
    for (const Metric metric : contested) {
      const Group* best = best_of(round, metric);
      if (best == nullptr) continue;
      const bool less = text_of(metric).less_is_better;
      const Estimate difference = paired_difference(ours.metric(metric), best->metric(metric));
      rows.push_back({ours.set + ": " + round_title(ours), metric_label(metric),
                      html::number(estimate(best->metric(metric))), display_name(best->policy),
                      html::number(estimate(ours.metric(metric))),
                      best == &ours ? "it is the best" : coloured(difference, less)});
    }
  }
  document.table(rows);
}

/// "The weights of this experiment: critical_late 10, ..."
class WeightsText {
 public:
  void operator()(const char* name, const double& value, Range, const char*) {
    text_ += (text_.empty() ? "" : ", ") + std::string(name) + " " + html::number(value);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string weights_text(CostWeights weights) {
  WeightsText text;
  weights.visit(text);
  return "The weights of this experiment, in units of one percent of class low: " + text.text() +
         ".";
}

}  // namespace

void add_costs(const Results& results, Document& document) {
  const auto rounds = contests(results);
  if (rounds.empty()) return;
  document.heading(2, "Judged by one cost");
  document.paragraph(
      "What users feel, in one number: the share of class critical and high that comes late "
      "(250 ms, and once more 1 s) or never, what of class low is not delivered, the age of the "
      "location, the delay of pictures, and the airtime that others cannot have. " +
      weights_text(results.experiment.timing.cost) +
      " Silence is no gain by itself: what it keeps from class low costs, and what it spares the "
      "others shows in their lateness.");
  for (const auto& round : rounds) {
    document.heading(3, round.front()->set + ": " + round_title(*round.front()));
    add_cost_figure(round, document);
    add_cost_table(round, document);
  }
  document.heading(3, "Which policy is best at what");
  document.paragraph(
      "The best mean of each round, and TOCP-DSP beside it; red where TOCP-DSP is worse with 95 % "
      "confidence. The best of several is picked from the same runs, so that it looks a little "
      "better than it is.");
  add_best_table(rounds, document);
}

}  // namespace tocsin::experiment
