// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "decision/cusum.hpp"

namespace tocsin::decision {

/// Which way a mean has moved.
enum class Shift { none, up, down };

/// Two-sided CUSUM for a shifted mean, the thesis's Algorithm 1:
/// g+ = max(0, g+ + x - mean - drift), g- = max(0, g- - x + mean - drift); alarm when either is
/// above (not at) the threshold, and both then start again at 0. For equal spreads it is the
/// log-likelihood CUSUM with drift = |change|/2 and threshold = alpha sd^2/|change|.
class MeanCusum {
 public:
  /// Throws ConfigError unless `drift` >= 0 and `threshold` > 0.
  MeanCusum(double mean, double drift, double threshold);
  /// Takes one value; NaN is ignored.
  Shift add(double x);
  [[nodiscard]] double up() const { return up_.statistic(); }
  [[nodiscard]] double down() const { return down_.statistic(); }
  /// Samples since the change that the last alarm reported; 0 before any alarm.
  [[nodiscard]] std::uint32_t run() const { return run_; }

 private:
  double mean_;
  double drift_;
  double threshold_;
  Cusum up_;
  Cusum down_;
  std::uint32_t run_ = 0;
};

}  // namespace tocsin::decision
