// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<Metric> agreed{Metric::qni_mean,
                                 Metric::probe_per_mean,
                                 Metric::telemetry_per,
                                 Metric::critical_lost,
                                 Metric::high_lost,
                                 Metric::low_lost,
                                 Metric::camera_lost,
                                 Metric::high_delivered,
                                 Metric::low_delivered,
                                 Metric::silent_in_good,
                                 Metric::high_latency_median,
                                 Metric::high_latency_p99,
                                 Metric::link_bytes,
                                 Metric::airtime,
                                 Metric::completion,
                                 Metric::stalled};

/// The values of simulated and real runs of the same seeds, run by run.
struct Pairs {
  std::vector<double> simulated;
  std::vector<double> real;
  [[nodiscard]] Estimate difference() const { return paired_difference(real, simulated); }
};

/// Which pairs count.
enum class Which {
  all,
  finished,  ///< those in which both vehicles reached their last waypoint
};

/// One simulated and one real run of the same seed.
struct Pair {
  const Group* simulated;
  std::size_t simulated_run;
  const Group* real;
  std::size_t real_run;
  [[nodiscard]] bool finished() const {
    return simulated->metric(Metric::completed)[simulated_run] == 1 &&
           real->metric(Metric::completed)[real_run] == 1;
  }
};

/// All that there are; a run that failed is in none.
std::vector<Pair> pairs_in(const Results& results) {
  std::vector<Pair> pairs;
  for (const Group& real : results.real) {
    const Group* simulated = find_group(results.groups, real, real.policy);
    if (simulated == nullptr) continue;
    for (std::size_t i = 0; i < real.indices.size(); ++i) {
      const auto& numbers = simulated->indices;
      const auto found = std::find(numbers.begin(), numbers.end(), real.indices[i]);
      if (found == numbers.end()) continue;
      const auto place = static_cast<std::size_t>(found - numbers.begin());
      if (simulated->values[place].empty() || real.values[i].empty()) continue;
      pairs.push_back({simulated, place, &real, i});
    }
  }
  return pairs;
}

Pairs values_of(const Results& results, Metric metric, Which which) {
  const std::size_t at = index_of(metric);
  Pairs pairs;
  for (const Pair& pair : pairs_in(results)) {
    if (which == Which::finished && !pair.finished()) continue;
    const double simulated = pair.simulated->values[pair.simulated_run][at];
    const double real = pair.real->values[pair.real_run][at];
    if (!std::isfinite(simulated) || !std::isfinite(real)) continue;
    pairs.simulated.push_back(simulated);
    pairs.real.push_back(real);
  }
  return pairs;
}

void add_scatter(const Results& results, Metric metric, Document& document) {
  const Pairs pairs = values_of(results, metric, Which::all);
  const std::string unit = text_of(metric).unit;
  const std::string name = text_of(metric).name;
  Figure figure("real_" + name, "Simulated and real, run by run: " + name);
  figure.axes("simulated [" + unit + "]", "real [" + unit + "]");
  figure.points("", pairs.simulated, pairs.real);
  if (!pairs.real.empty()) figure.diagonal();
  document.figure(std::move(figure), html::escape(text_of(metric).text) + ".");
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

void add_left_out(const Results& results, Document& document) {
  std::string names;
  std::size_t total = 0;
  for (const Pair& pair : pairs_in(results)) {
    ++total;
    if (pair.finished()) continue;
    names += (names.empty() ? "" : ", ") + pair.real->policy + " " +
             std::to_string(pair.real->indices[pair.real_run]);
  }
  document.paragraph(
      "The rule was set before these runs: a pair is left out of the right half when one of its "
      "two "
      "vehicles did not reach its last waypoint within the run (metric completed), because a "
      "vehicle "
      "that stands where the radio is dead measures that place for minutes. Both halves are shown. "
      "Of " +
      std::to_string(total) + " pairs left out: " + (names.empty() ? std::string("none") : names) +
      ".");
}

void add_table(const Results& results, Document& document) {
  std::vector<std::vector<std::string>> rows{
      {"metric", "simulated, all", "real, all", "real minus simulated", "pairs",
       "simulated, both finished", "real, both finished", "real minus simulated", "pairs"}};
  for (const Metric metric : agreed) {
    std::vector<std::string> row{metric_label(metric)};
    for (const Which which : {Which::all, Which::finished}) {
      const Pairs pairs = values_of(results, metric, which);
      const Estimate difference = pairs.difference();
      row.push_back(html::number(estimate(pairs.simulated)));
      row.push_back(html::number(estimate(pairs.real)));
      row.push_back(html::number(difference));
      row.push_back(std::to_string(difference.runs));
    }
    rows.push_back(std::move(row));
  }
  document.table(rows);
}

void add_targets(const Results& results, Document& document) {
  std::string list;
  for (const Which which : {Which::all, Which::finished}) {
    const std::string of = which == Which::all ? ", all pairs," : ", both finished,";
    list += target(values_of(results, Metric::qni_mean, which).difference(), 2, "mean QNI" + of);
    list += target(values_of(results, Metric::high_delivered, which).difference(), 2,
                   "delivered share of class high" + of);
  }
  document.add("<ul>" + list + "</ul>\n");
}

}  // namespace

void add_reality(const Results& results, Document& document) {
  if (results.real.empty()) return;
  document.heading(2, "Simulated against real");
  document.paragraph(
      "The same seeds through the whole real stack: processes, Fast DDS, IP packets "
      "through the link emulator, real time. Observations in which the emulator was "
      "more than 50 ms late, because the machine froze, are marked (stalled).");
  if (pairs_in(results).empty()) {
    document.paragraph(
        "There are no simulated runs of these seeds yet: tocsin experiment run FILE without "
        "--real, "
        "into the same folder, makes them.");
    return;
  }
  add_table(results, document);
  add_left_out(results, document);
  add_targets(results, document);
  add_scatter(results, Metric::qni_mean, document);
  add_scatter(results, Metric::high_delivered, document);
}

}  // namespace tocsin::experiment
