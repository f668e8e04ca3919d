// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<std::string> shown{"qni_mean",         "probe_per_mean", "telemetry_per",
                                     "high_delivered",   "low_delivered",  "high_latency_median",
                                     "high_latency_p99", "link_bytes",     "airtime",
                                     "completion",       "stalled"};

/// The values of a simulated and of a real group, run by run.
struct Pairs {
  std::vector<double> simulated;
  std::vector<double> real;
  std::vector<std::string> left_out;
};

/// Adds the pairs in which both vehicles did their mission; names the others in `left_out`.
void add_pairs(const Group& simulated, const Group& real, const std::string& metric, Pairs& pairs) {
  const auto a = simulated.metric(metric);
  const auto b = real.metric(metric);
  const auto done_a = simulated.metric("completed");
  const auto done_b = real.metric("completed");
  for (std::size_t i = 0; i < real.indices.size(); ++i) {
    const auto found =
        std::find(simulated.indices.begin(), simulated.indices.end(), real.indices[i]);
    if (found == simulated.indices.end()) continue;
    const auto place = static_cast<std::size_t>(found - simulated.indices.begin());
    const double value = a[place];
    if (!(done_a[place] == 1 && done_b[i] == 1)) {
      pairs.left_out.push_back(real.policy + " " + std::to_string(real.indices[i]));
      continue;
    }
    if (!std::isfinite(value) || !std::isfinite(b[i])) continue;
    pairs.simulated.push_back(value);
    pairs.real.push_back(b[i]);
  }
}

Pairs pairs_of(const Results& results, const std::string& metric) {
  Pairs pairs;
  for (const Group& real : results.real) {
    const Group* simulated = find_group(results.groups, real, real.policy);
    if (simulated != nullptr) add_pairs(*simulated, real, metric, pairs);
  }
  return pairs;
}

void add_scatter(const Results& results, const std::string& metric, Document& document) {
  const Pairs pairs = pairs_of(results, metric);
  const std::string unit = metric_texts()[metric_index(metric)].unit;
  Figure figure("real_" + metric, "Simulated and real, run by run: " + metric);
  figure.axes("simulated [" + unit + "]", "real [" + unit + "]");
  figure.points("", pairs.simulated, pairs.real);
  if (!pairs.real.empty()) figure.diagonal();
  document.figure(std::move(figure), html::escape(metric_texts()[metric_index(metric)].text) + ".");
}

constexpr int wanted_pairs = 20;

std::string target(const Estimate& difference, double limit, const std::string& what) {
  const bool close = std::fabs(difference.mean) <= limit;
  const bool enough = difference.runs >= wanted_pairs;
  const char* kind = !close ? "no" : enough ? "yes" : "open";
  const char* word = !close ? "not met" : enough ? "met" : "so far, over too few pairs";
  return "<li><span class=\"" + std::string(kind) + "\">" + word + "</span>: " + what + " within " +
         html::number(limit) + " over at least " + std::to_string(wanted_pairs) +
         " paired runs; real minus simulated " + html::number(difference) + " over " +
         std::to_string(difference.runs) + " pairs.</li>\n";
}

void add_left_out(const Pairs& pairs, Document& document) {
  std::string names;
  for (const std::string& name : pairs.left_out) names += (names.empty() ? "" : ", ") + name;
  document.paragraph(
      "Left out of the table, because one of the two did not finish its mission (a vehicle that "
      "stands where the radio is dead measures that place for minutes): " +
      (names.empty() ? std::string("none") : names) + ".");
}

}  // namespace

void add_reality(const Results& results, Document& document) {
  if (results.real.empty()) return;
  document.heading(2, "Simulated against real");
  document.paragraph(
      "The same seeds through the whole real stack: processes, Fast DDS, IP packets "
      "through the link emulator, real time. Observations in which the emulator was "
      "more than 50 ms late, because the machine froze, are marked (stalled).");
  std::vector<std::vector<std::string>> rows{
      {"metric", "simulated", "real", "real minus simulated", "pairs"}};
  for (const std::string& metric : shown) {
    const Pairs pairs = pairs_of(results, metric);
    const Estimate difference = paired_difference(pairs.real, pairs.simulated);
    rows.push_back({metric + " [" + metric_texts()[metric_index(metric)].unit + "]",
                    html::number(estimate(pairs.simulated)), html::number(estimate(pairs.real)),
                    html::number(difference), std::to_string(difference.runs)});
  }
  document.table(rows);
  add_left_out(pairs_of(results, "qni_mean"), document);
  const auto difference = [&](const char* metric) {
    const Pairs pairs = pairs_of(results, metric);
    return paired_difference(pairs.real, pairs.simulated);
  };
  document.add("<ul>" + target(difference("qni_mean"), 2, "mean QNI") +
               target(difference("high_delivered"), 2, "delivered share of class high") +
               "</ul>\n");
  add_scatter(results, "qni_mean", document);
  add_scatter(results, "high_delivered", document);
}

}  // namespace tocsin::experiment
