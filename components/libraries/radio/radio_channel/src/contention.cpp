// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/contention.hpp"

#include <algorithm>
#include <cmath>

#include "radio_channel/ofdm.hpp"

namespace tocsin::radio {
namespace {

/// Attempt probability of a saturated station whose attempts collide with probability `p`.
double attempt_probability(double p) {
  constexpr double window = cw_min + 1;
  constexpr int doublings = 6;
  double sum = 0;  // of (2p)^i; Bianchi's closed form is 0/0 at p = 1/2
  for (int i = 0; i < doublings; ++i) sum += std::pow(2 * p, i);
  return 2 / (1 + window + p * window * sum);
}

/// Share of the time that `stations` keep busy when saturated.
double saturated_share(int stations, Duration frame) {
  const double none = std::pow(1 - saturation(stations).attempt, stations);
  const double busy_s = (1 - none) * to_seconds(frame);
  return busy_s / (busy_s + none * to_seconds(slot_time));
}

}  // namespace

Saturation saturation(int stations) {
  double low = 0;
  double high = 1;
  while (high - low > 1e-12) {
    const double p = (low + high) / 2;
    (1 - std::pow(1 - attempt_probability(p), stations - 1) > p ? low : high) = p;
  }
  return {attempt_probability(low), low};
}

BackgroundLoad::BackgroundLoad(double load, int stations, Duration frame)
    : load_(load),
      most_(stations),
      arrivals_per_ns_(load / (1 - load) / static_cast<double>(frame.count())),
      frame_(frame) {
  const double activity = std::min(1.0, load / saturated_share(stations, frame));
  collision_ = 1 - std::pow(1 - activity * saturation(stations + 1).attempt, stations);
}

Duration BackgroundLoad::until_idle(RandomStream& random) const {
  if (load_ == 0 || !random.chance(load_)) return Duration::zero();
  return Duration{
      static_cast<std::int64_t>(random.uniform() * static_cast<double>(frame_.count()))};
}

Duration BackgroundLoad::interruptions(Duration elapsed, RandomStream& random) const {
  if (load_ == 0) return Duration::zero();
  const double expected = arrivals_per_ns_ * static_cast<double>(elapsed.count());
  return random.poisson(std::min(expected, most_)) * (frame_ + difs);
}

}  // namespace tocsin::radio
