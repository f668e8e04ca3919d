// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using navigation::Mission;
using navigation::Pose2;

constexpr Time t0{std::chrono::hours(1)};
constexpr std::uint64_t wall0_ms = 1'780'000'000'000;

const Mission two_waypoints{"two", "map", {{1, 0, 0}, {5, 0, 1.5}}, "two.yaml"};

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

TEST_F(MissionControlTest, TellsTheWaypointsAheadAndTheirIds) {
  const auto first = first_goal();
  ASSERT_EQ(first.ahead.size(), 1U);
  EXPECT_EQ(first.ahead[0].x, 5);
  hear(1);
  const auto second = at(3).value();
  EXPECT_EQ(second.id, first.id + 1);
  EXPECT_TRUE(second.ahead.empty());
}

TEST_F(MissionControlTest, TellsNoMoreAheadThanItIsTold) {
  const Mission five{"five", "map", {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}, ""};
  for (const int ahead : {0, 3, 4, 5}) {
    MissionControl::Params params;
    params.goals_ahead = ahead;
    MissionControl control(params, five);
    control.on_location({-5, 0, 0}, t0);
    const auto goal = control.update(t0 + seconds(2), wall0_ms).value();
    EXPECT_EQ(goal.ahead.size(), static_cast<std::size_t>(std::min(ahead, 4)));
  }
}

TEST_F(MissionControlTest, FollowsAVehicleThatHasGoneOnByItself) {
  const auto first = first_goal();
  hear(first.id + 1, "driving");
  EXPECT_EQ(at(2.1).value().id, first.id + 1);  // renews the lease and tells what is ahead of it
  EXPECT_EQ(progress().waypoint, 1U);
  ASSERT_EQ(sut.arrivals().size(), 1U);
  EXPECT_FALSE(sut.arrivals()[0].by_location);
  hear(first.id + 1, "reached");
  (void)at(3);
  EXPECT_EQ(progress().state, MissionControl::State::done);
}

TEST_F(MissionControlTest, GoesOnAheadWhereAnEarlierOneWasSilentMeanwhile) {
  const auto first = first_goal();
  MissionControl anew({}, two_waypoints);
  anew.on_status(first.id + 1, "driving", now_);
  const auto renewed = anew.update(now_, wall0_ms + 11'000).value();
  EXPECT_EQ(renewed.waypoint, 1U);
  EXPECT_EQ(renewed.id, first.id + 1);
}

TEST_F(MissionControlTest, GoesOnWhereAnEarlierOneWas) {
  (void)first_goal();
  hear(1);
  const auto second = at(10).value();
  MissionControl anew({}, two_waypoints);
  anew.on_status(second.id, "driving", now_);
  const auto renewed = anew.update(now_, wall0_ms + 11'000).value();
  EXPECT_EQ(renewed.waypoint, 1U);
  EXPECT_EQ(renewed.id, second.id);
}

TEST_F(MissionControlTest, GoesOnBehindAWaypointThatWasReachedMeanwhile) {
  const auto first = first_goal();
  MissionControl anew({}, two_waypoints);
  anew.on_status(first.id, "reached", now_);
  EXPECT_EQ(anew.update(now_, wall0_ms).value().waypoint, 1U);
}

TEST_F(MissionControlTest, StartsOverWhenTheVehicleDrivesForAnotherMission) {
  const auto first = first_goal();
  MissionControl other({}, {"other", "map", {{9, 9, 0}, {8, 8, 0}}, ""});
  other.on_status(GoalId::unpack(first.id).packed() + 1, "driving", now_);
  const auto goal = other.update(now_, wall0_ms).value();
  EXPECT_EQ(goal.waypoint, 0U);
  EXPECT_GT(goal.id, first.id);
}

TEST_F(MissionControlTest, StartsOverWhenItIsToldNotToResume) {
  (void)first_goal();
  hear(1);
  const auto second = at(10).value();
  MissionControl::Params params;
  params.resume = false;
  MissionControl anew(params, two_waypoints);
  anew.on_status(second.id, "driving", now_);
  const auto goal = anew.update(now_, wall0_ms).value();
  EXPECT_EQ(goal.waypoint, 0U);
  EXPECT_GT(goal.id, second.id);
}

TEST_F(MissionControlTest, IdsGrowEvenWhenTheWallClockIsSetBack) {
  const auto first = first_goal();
  hear(1);
  const auto second = sut.update(t0 + seconds(3), wall0_ms - 3'600'000).value();
  EXPECT_GT(second.id, first.id);
}

TEST_F(MissionControlTest, SupersedesAGoalOfSomebodyElse) {
  const auto first = first_goal();
  hear(first.id + (1U << 30U), "driving");
  const auto again = at(5);
  ASSERT_TRUE(again);
  EXPECT_GT(again->id, first.id + (1U << 30U));
  EXPECT_EQ(again->waypoint, 0U);
}

}  // namespace
}  // namespace tocsin
