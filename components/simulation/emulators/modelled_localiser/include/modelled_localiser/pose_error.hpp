// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"

namespace tocsin {

/// How a localiser errs. The defaults are those of package localisation among boxes.
struct PoseErrorParams {
  double deviation_m = 0.015;
  double deviation_rad = 0.005;
  double correlation_s = 2;
  double lost_every_s = 0;
  double lost_for_s = 5;
  template <class Visitor>
  void visit(Visitor& v) {
    v("deviation_m", deviation_m, {0, 10}, "[m] usual error of x and of y");
    v("deviation_rad", deviation_rad, {0, 3}, "[rad] of the heading");
    v("correlation_s", correlation_s, {0.01, 1000}, "[s] in which an error becomes another one");
    v("lost_every_s", lost_every_s, {0, 1e6},
      "[s] mean time until it does not know where it is; 0: it always knows");
    v("lost_for_s", lost_for_s, {0.1, 1000},
      "[s] it does not know, then and after the vehicle was carried off");
  }
};

/// What a localiser would say of a true pose: an error that is a Gauss-Markov process of first
/// order, and times at which it does not know.
///
/// Pure and deterministic; `now` must not decrease.
class PoseError {
 public:
  PoseError(const PoseErrorParams& params, std::uint64_t seed);

  /// Empty: it does not know where the vehicle is.
  [[nodiscard]] std::optional<geometry::Pose> read(const geometry::Pose& truth, Time now);

 private:
  void drift(Time now);
  [[nodiscard]] bool is_lost(const geometry::Pose& truth, Time now);

  PoseErrorParams params_;
  std::mt19937_64 random_;
  std::normal_distribution<> normal_;
  geometry::Pose error_;  ///< in deviations
  std::optional<Time> last_;
  geometry::Pose last_truth_;
  std::optional<Time> next_loss_;
  Time lost_until_ = Time::min();
};

}  // namespace tocsin
