// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace tocsin::experiment {

/// A mean and where it lies with 95 % confidence (Student's t over runs).
struct Estimate {
  double mean;  ///< NaN: no run had an answer
  double low;   ///< NaN with fewer than two runs
  double high;
  int runs;  ///< that had an answer
  [[nodiscard]] bool below(double value) const { return high < value; }
  [[nodiscard]] bool above(double value) const { return low > value; }
};

/// NaN values are runs without an answer.
[[nodiscard]] Estimate estimate(const std::vector<double>& values);

/// Mean of a[i] - b[i] over the runs in which both have an answer. Same length, paired by index.
[[nodiscard]] Estimate paired_difference(const std::vector<double>& a,
                                         const std::vector<double>& b);

/// The mean over groups of the groups' means, with the interval over groups: where runs of a group
/// have something random in common (the fit of their parameters), it holds the chance of that, too.
/// `group` has a number for each value. Groups without an answer are left out; `runs` counts
/// groups.
[[nodiscard]] Estimate estimate_over_groups(const std::vector<double>& values,
                                            const std::vector<int>& group);

/// 97.5 % quantile of Student's t with `degrees` of freedom, at least 1.
[[nodiscard]] double t_quantile_975(int degrees);

}  // namespace tocsin::experiment
