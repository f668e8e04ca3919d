// SPDX-License-Identifier: Apache-2.0
#include "tune/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace tocsin::qos_tool {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double mean_of(const std::vector<double>& values) {
  return values.empty() ? unknown
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

/// Mission, channel, payload and seed: runs that met the same radio.
using RadioKey = std::string;
using RowOfRadio = std::map<RadioKey, std::size_t>;

/// The rows of runs that ended well, by candidate.
std::map<std::string, RowOfRadio> rows_by_candidate(const CsvTable& runs) {
  std::map<std::string, RowOfRadio> rows;
  for (std::size_t row = 0; row < runs.rows(); ++row) {
    if (!runs.text(row, "failure").empty() || std::isnan(runs.number(row, "user_cost"))) continue;
    const RadioKey radio = runs.text(row, "mission") + '/' + runs.text(row, "channel") + '/' +
                           runs.text(row, "payload") + '/' + runs.text(row, "index");
    rows[runs.text(row, "policy")][radio] = row;
  }
  return rows;
}

/// Mean of a column over those rows in which it has an answer.
double column_mean(const CsvTable& runs, const std::vector<std::size_t>& rows,
                   const std::string& column) {
  std::vector<double> values;
  for (const std::size_t row : rows) {
    const double value = runs.number(row, column);
    if (!std::isnan(value)) values.push_back(value);
  }
  return mean_of(values);
}

RankedCandidate summary_of(const CsvTable& runs, const Candidate& candidate, const RowOfRadio& own,
                           const RowOfRadio& shipped, std::size_t comparisons) {
  std::vector<std::size_t> rows;
  std::vector<double> differences;
  for (const auto& [radio, row] : own) {
    const auto other = shipped.find(radio);
    if (other == shipped.end()) continue;
    rows.push_back(row);
    differences.push_back(runs.number(row, "user_cost") - runs.number(other->second, "user_cost"));
  }
  return {candidate,
          rows.size(),
          column_mean(runs, rows, "user_cost"),
          mean_interval(differences, comparisons),
          column_mean(runs, rows, "critical_late"),
          column_mean(runs, rows, "high_late"),
          column_mean(runs, rows, "low_delivered"),
          column_mean(runs, rows, "location_age_p99"),
          column_mean(runs, rows, "picture_latency_p99")};
}

bool is_shipped(const RankedCandidate& one) { return one.candidate.settings.empty(); }

/// "better", "worse", or what the runs do not tell.
std::string verdict_of(const RankedCandidate& one) {
  if (one.difference.high < 0) return "better";
  return one.difference.low > 0 ? "worse" : "not told apart";
}

/// [1] of the shipped cost: what is less is no reason to change.
constexpr double worthwhile_share = 0.05;

/// By how much a candidate may yet cost less than what is shipped; NaN with too few runs.
double possible_gain(const RankedCandidate& one) { return -one.difference.low; }

/// The candidate of which least is known: the widest gain that the runs leave possible.
const RankedCandidate* least_known(const std::vector<RankedCandidate>& ranked) {
  const RankedCandidate* found = nullptr;
  for (const RankedCandidate& one : ranked) {
    if (is_shipped(one)) continue;
    if (std::isnan(possible_gain(one))) return &one;
    if (found == nullptr || possible_gain(one) > possible_gain(*found)) found = &one;
  }
  return found;
}

std::string without_better(const std::vector<RankedCandidate>& ranked) {
  const auto shipped = std::find_if(ranked.begin(), ranked.end(), is_shipped);
  const RankedCandidate* const open = least_known(ranked);
  if (shipped == ranked.end() || open == nullptr) return "Nothing was compared.\n";
  const std::string none =
      "No candidate costs less than what is shipped by more than the runs' chance";
  if (std::isnan(possible_gain(*open))) {
    return none + ", but one run of a candidate tells nothing: add seeds.\n";
  }
  if (possible_gain(*open) <= worthwhile_share * shipped->cost) {
    return fmt::format("{}, and none by more than {:.2f} of {:.2f}: it stands confirmed.\n", none,
                       std::max(possible_gain(*open), 0.0), shipped->cost);
  }
  return fmt::format(
      "{}, but the runs leave open whether {} costs up to {:.2f} less (of {:.2f}): add seeds.\n",
      none, open->candidate.name, possible_gain(*open), shipped->cost);
}

std::string conclusion_of(const std::vector<RankedCandidate>& ranked) {
  const auto best = std::find_if(ranked.begin(), ranked.end(), [](const RankedCandidate& one) {
    return !is_shipped(one) && verdict_of(one) == "better";
  });
  if (best == ranked.end()) return without_better(ranked);
  return fmt::format(
      "Costs least, and less than what is shipped by {:.2f} [{:.2f}, {:.2f}] (95 % for all of "
      "them): {}, {}.\n",
      -best->difference.mean, -best->difference.high, -best->difference.low, best->candidate.name,
      settings_text(best->candidate));
}

}  // namespace

MeanInterval mean_interval(const std::vector<double>& values, std::size_t comparisons) {
  const double mean = mean_of(values);
  if (values.size() < 2) return {mean, unknown, unknown};
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(values.size());
  const double error = std::sqrt(squares / (count - 1) / count);
  const double t = boost::math::quantile(boost::math::complement(
      boost::math::students_t(count - 1),
      0.05 / 2 / static_cast<double>(std::max<std::size_t>(comparisons, 1))));
  return {mean, mean - t * error, mean + t * error};
}

std::vector<RankedCandidate> rank(const CsvTable& runs, const std::vector<Candidate>& candidates) {
  const auto rows = rows_by_candidate(runs);
  std::vector<RankedCandidate> ranked;
  const auto shipped = rows.find("shipped");
  if (shipped == rows.end()) return ranked;
  for (const Candidate& candidate : candidates) {
    const auto own = rows.find(candidate.name);
    if (own == rows.end()) continue;
    ranked.push_back(
        summary_of(runs, candidate, own->second, shipped->second, candidates.size() - 1));
    if (ranked.back().runs == 0) ranked.pop_back();
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return ranked;
}

std::string ranking_text(const std::vector<RankedCandidate>& ranked) {
  if (ranked.empty()) return "no run ended well\n";
  std::string text = fmt::format("{:<8} {:>5} {:>7} {:>24} {:>9} {:>7} {:>9} {:>9} {:>8}  {}\n",
                                 "name", "runs", "cost", "minus shipped [95 % all]", "critical",
                                 "high", "low", "location", "picture", "settings");
  text += fmt::format("{:<8} {:>5} {:>7} {:>24} {:>9} {:>7} {:>9} {:>9} {:>8}\n", "", "", "", "",
                      "late %", "late %", "deliv. %", "age s", "p99 ms");
  for (const RankedCandidate& one : ranked) {
    const std::string difference =
        is_shipped(one) ? ""
                        : fmt::format("{:+.2f} [{:+.2f}, {:+.2f}]", one.difference.mean,
                                      one.difference.low, one.difference.high);
    text += fmt::format(
        "{:<8} {:>5} {:>7.2f} {:>24} {:>9.2f} {:>7.2f} {:>9.1f} {:>9.3f} {:>8.0f}  {}{}\n",
        one.candidate.name, one.runs, one.cost, difference, one.critical_late, one.high_late,
        one.low_delivered, one.location_age_p99, one.picture_p99, settings_text(one.candidate),
        is_shipped(one) ? "" : " (" + verdict_of(one) + ")");
  }
  return text + conclusion_of(ranked);
}

}  // namespace tocsin::qos_tool
