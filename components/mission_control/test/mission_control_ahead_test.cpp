// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mission_control_fixture.hpp"

namespace tocsin {
namespace {

using navigation::Mission;

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
