// SPDX-License-Identifier: Apache-2.0
#include "navigator/obstacle_inputs.hpp"

#include <array>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

/// Of what presses a bumper, from the middle of the base, and of the floor that a sensor misses.
constexpr double touched_m = 0.2;
/// Of the left, the centre and the right sensor.
constexpr std::array<double, 3> bearings_rad{pi / 4, 0, -pi / 4};

}  // namespace

ObstacleInputs::ObstacleInputs(Component& owner)
    : scan_(owner, WakeMode::time_triggered),
      bumper_(owner, WakeMode::time_triggered),
      cliff_(owner, WakeMode::time_triggered) {}

void ObstacleInputs::on_pose(std::int64_t stamp_ns, const geometry::Pose& pose,
                             const geometry::Twist& velocity) {
  poses_.add(stamp_ns, pose);
  velocity_ = velocity;
}

void ObstacleInputs::take(Navigator& navigator, Time now) {
  if (const auto turn = scan_.take(velocity_)) {
    navigator.on_scan(turn->scan, poses_.at(turn->stamp_ns), now);
  }
  while (const auto event = bumper_.take()) {
    if (event->state() == 0 || event->bumper() >= bearings_rad.size()) continue;
    navigator.on_touch(bearings_rad[event->bumper()], touched_m, now);
  }
  while (const auto event = cliff_.take()) {
    if (event->state() == 0 || event->sensor() >= bearings_rad.size()) continue;
    navigator.on_touch(bearings_rad[event->sensor()], touched_m, now);
  }
}

}  // namespace tocsin
