// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "foundation/csv_table.hpp"
#include "tune/tune_plan.hpp"

namespace tocsin::qos_tool {

/// A mean with its interval (Student's t over runs), which is NaN with fewer than two runs.
struct MeanInterval {
  double mean;
  double low;
  double high;
};

/// The interval of one of `comparisons`, so wide that all of them hold together with 95 % at least
/// (Bonferroni).
[[nodiscard]] MeanInterval mean_interval(const std::vector<double>& values,
                                         std::size_t comparisons = 1);

/// What came of one candidate.
struct RankedCandidate {
  Candidate candidate;
  std::size_t runs;         ///< that ended well for it and for the shipped one
  double cost;              ///< mean of the one cost of `tocsin experiment`
  MeanInterval difference;  ///< of the cost to the shipped one's, paired by mission, channel, seed
  double critical_late;     ///< [%] means of what users feel
  double high_late;         ///< [%]
  double low_delivered;     ///< [%]
  double location_age_p99;  ///< [s]
  double picture_p99;       ///< [ms]
};

/// The candidates by their mean cost, the least first, of a `runs.csv` of `tocsin experiment`.
/// Those without a run that ended well are left out.
[[nodiscard]] std::vector<RankedCandidate> rank(const CsvTable& runs,
                                                const std::vector<Candidate>& candidates);

/// A table for people, and a sentence that says what follows from it.
[[nodiscard]] std::string ranking_text(const std::vector<RankedCandidate>& ranked);
}  // namespace tocsin::qos_tool
