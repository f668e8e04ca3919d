// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "mission_control/mission_control.hpp"

namespace tocsin {

inline constexpr Time t0{std::chrono::hours(1)};
inline const navigation::Mission two_waypoints{
    "two", "map", {{{1, 0, 0}}, {{5, 0, 1.5}}}, "two.yaml"};

/// A mission control with a clock, and a vehicle that can be heard.
class MissionControlTest : public ::testing::Test {
 protected:
  std::optional<MissionControl::Goal> at(double s) {
    now_ = t0 + seconds(s);
    return sut.update(now_);
  }
  void hear(double x) { sut.on_location({x, 0, 0}, now_); }
  void hear(const GoalName& goal, const char* state) { sut.on_status(goal, state, now_); }
  static GoalName after(GoalName goal, std::uint64_t ids = 1) {
    return {goal.mission, goal.id + ids};
  }
  /// Runs to the first goal, at 2 s.
  MissionControl::Goal first_goal() {
    (void)at(0);
    hear(-5);
    return at(2).value();
  }
  MissionControl::Progress progress() { return sut.progress(now_); }

  MissionControl sut{{}, two_waypoints, 1};
  Time now_ = t0;
};

}  // namespace tocsin
