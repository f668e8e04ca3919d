// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "metrics/metrics.hpp"
#include "plan/experiment_file.hpp"

namespace tocsin::experiment {

/// The runs of one combination, paired with those of other policies by their order.
struct Group {
  std::string set;
  std::string mission;
  std::string channel;
  std::string payload;
  std::string policy;
  std::vector<int> indices;                      ///< numbers of the seeds, ascending
  std::vector<std::vector<double>> values;       ///< of each run, as metric_texts; empty: failed
  std::vector<std::vector<Observation>> series;  ///< of each run
  /// The metric in every run; NaN where it has no answer.
  [[nodiscard]] std::vector<double> metric(Metric metric) const;
};

/// Everything in the folder of an experiment.
struct Results {
  std::string folder;
  std::string build;
  std::string settings;  ///< the whole text
  Experiment experiment;
  Fitted fitted;              ///< what the settings hold of it
  std::vector<Group> groups;  ///< simulated, in the order of the plan
  std::vector<Group> real;    ///< driven; empty without `real.csv`
  std::size_t runs = 0;
  std::vector<std::string> failures;  ///< "run: why"
};

/// Throws ConfigError when the folder holds no results.
[[nodiscard]] Results load_results(const std::string& folder);

/// The group of a combination; null when there is none.
[[nodiscard]] const Group* find_group(const std::vector<Group>& groups, const Group& like,
                                      const std::string& policy);

/// Groups of the same set, mission, channel and payload, in order.
[[nodiscard]] std::vector<std::vector<const Group*>> rounds_of(const std::vector<Group>& groups,
                                                               const std::string& set);

/// Mean over the runs of a group at each observation that at least half of them reached.
/// `value` is NaN where an observation has no answer.
[[nodiscard]] std::vector<double> mean_series(
    const Group& group, const std::function<double(const Observation&)>& value);
/// The same for a percentile; `share` in (0, 1].
[[nodiscard]] std::vector<double> percentile_series(
    const Group& group, const std::function<double(const Observation&)>& value, double share);

}  // namespace tocsin::experiment
