// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/time.hpp"
#include "radio_channel/random.hpp"

namespace tocsin::radio {

/// How often saturated stations collide.
struct Saturation {
  double attempt;    ///< probability that one station transmits in a slot (tau)
  double collision;  ///< probability that a transmission meets another one (p)
};

/// Bianchi's fixed point ("Performance analysis of the IEEE 802.11 distributed coordination
/// function", 2000, equations 7 and 9) for `stations` >= 1, contention windows 16 to 1024.
[[nodiscard]] Saturation saturation(int stations);

/// What other stations do to ours: they take a share of the time and collide with us.
///
/// Each of them attempts as often as Bianchi's saturated station, scaled by the load over the load
/// at saturation. Their frames arrive as a Poisson process.
class BackgroundLoad {
 public:
  /// `load` in [0, 1) of the time, by `stations` >= 1 with frames of `frame`.
  BackgroundLoad(double load, int stations, Duration frame);
  /// Probability that one of our transmissions is hit.
  [[nodiscard]] double collision() const { return collision_; }
  [[nodiscard]] double load() const { return load_; }
  /// Time until a medium found at a random instant is idle.
  [[nodiscard]] Duration until_idle(RandomStream& random) const;
  /// Time the others take before our next attempt, having waited for `elapsed`. In saturation each
  /// station gets one turn for one of ours.
  [[nodiscard]] Duration interruptions(Duration elapsed, RandomStream& random) const;

 private:
  double load_;
  double most_;             // frames of the others for one of ours
  double arrivals_per_ns_;  // of their frames while the medium is not theirs
  Duration frame_;
  double collision_;
};

}  // namespace tocsin::radio
