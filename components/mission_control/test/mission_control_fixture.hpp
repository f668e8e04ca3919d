// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "mission_control/mission_control.hpp"

namespace tocsin {

inline constexpr Time t0{std::chrono::hours(1)};
inline constexpr std::uint64_t wall0_ms = 1'780'000'000'000;

inline const navigation::Mission two_waypoints{"two", "map", {{1, 0, 0}, {5, 0, 1.5}}, "two.yaml"};

/// A mission control with a clock, and a vehicle that can be heard.
class MissionControlTest : public ::testing::Test {
 protected:
  std::optional<MissionControl::Goal> at(double s) {
    now_ = t0 + seconds(s);
    return sut.update(now_, wall0_ms + static_cast<std::uint64_t>(std::llround(s * 1000)));
  }
  void hear(double x) { sut.on_location({x, 0, 0}, now_); }
  void hear(std::uint64_t goal_id, const char* state) { sut.on_status(goal_id, state, now_); }
  /// Runs to the first goal, at 2 s.
  MissionControl::Goal first_goal() {
    (void)at(0);
    hear(-5);
    return at(2).value();
  }
  MissionControl::Progress progress() { return sut.progress(now_); }

  MissionControl sut{{}, two_waypoints};
  Time now_ = t0;
};

}  // namespace tocsin
