// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "foundation/error.hpp"
#include "mission_control_fixture.hpp"

namespace tocsin {
namespace {

using navigation::Mission;

bool operator==(const GoalName& a, const GoalName& b) {
  return a.mission == b.mission && a.id == b.id;
}

TEST_F(MissionControlTest, SendsNothingBeforeTheVehicleIsHeard) {
  EXPECT_FALSE(at(0));
  EXPECT_FALSE(at(1000));
  EXPECT_EQ(progress().state, MissionControl::State::waiting);
}

TEST_F(MissionControlTest, StartsWhenTheVehicleWasHeardForTheResumeWait) {
  (void)at(0);
  hear(-5);
  EXPECT_FALSE(at(1.999));
  const auto goal = at(2);
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->waypoint, 0U);
  EXPECT_EQ(goal->pose.x_m, 1);
  EXPECT_EQ(goal->tolerance_m, 0.15);
  EXPECT_EQ(goal->lifetime_s, 60);
  EXPECT_EQ(progress().state, MissionControl::State::running);
}

TEST_F(MissionControlTest, IgnoresALocationThatIsNotFinite) {
  (void)at(0);
  hear(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(at(10));
}

TEST_F(MissionControlTest, RepeatsAnUnansweredGoalWithTheSameId) {
  const auto first = first_goal();
  EXPECT_FALSE(at(4.999));
  const auto second = at(5);
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->name == first.name);
  EXPECT_EQ(progress().goals_sent, 2U);
}

TEST_F(MissionControlTest, RenewsAnAnsweredGoalAfterHalfItsLifetime) {
  const auto first = first_goal();
  for (double s = 2; s <= 31; s += 1) {
    hear(first.name, "driving");
    EXPECT_FALSE(at(s + 0.999));
  }
  const auto renewal = at(32);
  ASSERT_TRUE(renewal);
  EXPECT_TRUE(renewal->name == first.name);
}

TEST_F(MissionControlTest, RepeatsAnAnsweredGoalWhileTheVehicleIsNotHeard) {
  const auto first = first_goal();
  (void)at(2.5);
  hear(first.name, "driving");
  EXPECT_FALSE(at(5.499));
  const auto again = at(5.5);
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->name == first.name);
}

TEST_F(MissionControlTest, RepeatsAGoalThatTheVehicleOnlyHolds) {
  const auto first = first_goal();
  hear(first.name, "held");
  EXPECT_TRUE(at(5));
}

TEST_F(MissionControlTest, RepeatsWhenANavigatorThatWasRestartedForgotTheGoal) {
  hear(first_goal().name, "driving");
  EXPECT_FALSE(at(4.9));
  hear(GoalName{}, "idle");
  EXPECT_TRUE(at(5));
}

TEST_F(MissionControlTest, ArrivesByALocationAtTheLimitButNotBeyond) {
  (void)first_goal();
  hear(0.849);
  EXPECT_FALSE(at(3));
  hear(0.851);
  const auto next = at(3.1);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->waypoint, 1U);
}

TEST_F(MissionControlTest, ArrivesByTheNavigatorsStatus) {
  const auto first = first_goal();
  hear(first.name, "reached");
  const auto next = at(3);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->waypoint, 1U);
  EXPECT_TRUE(next->name == after(first.name));
}

TEST_F(MissionControlTest, DoesNotArriveByAStatusOfAnotherGoal) {
  (void)first_goal();
  hear(GoalName{7, 1}, "reached");
  (void)at(3);
  EXPECT_EQ(progress().waypoint, 0U);
}

TEST_F(MissionControlTest, DoesNotArriveTwiceByOneStatus) {
  const auto first = first_goal();
  hear(first.name, "reached");
  (void)at(3);
  hear(first.name, "reached");
  (void)at(4);
  EXPECT_EQ(progress().waypoint, 1U);
  EXPECT_EQ(progress().state, MissionControl::State::running);
}

TEST_F(MissionControlTest, SendsAGoalForAWaypointWhereTheVehicleStandsAlready) {
  (void)at(0);
  hear(1);
  EXPECT_EQ(at(2).value().waypoint, 0U);
  EXPECT_EQ(at(2.1).value().waypoint, 1U);
}

TEST_F(MissionControlTest, IsDoneAfterTheLastWaypointAndSendsNoMore) {
  (void)first_goal();
  hear(1);
  (void)at(10);
  hear(5);
  EXPECT_FALSE(at(30));
  EXPECT_EQ(progress().state, MissionControl::State::done);
  EXPECT_FALSE(at(1000));
  EXPECT_DOUBLE_EQ(progress().elapsed_s, 28);
}

TEST_F(MissionControlTest, AbortsWhenBlockedForLongerThanTheLimit) {
  const auto first = first_goal();
  hear(first.name, "blocked");
  for (double s = 3; s <= 62; s += 1) {
    (void)at(s);
    hear(first.name, "blocked");
  }
  EXPECT_EQ(progress().state, MissionControl::State::running);
  (void)at(62.001);
  EXPECT_EQ(progress().state, MissionControl::State::aborted);
  EXPECT_EQ(progress().reason, "waypoint 1 is blocked");
  EXPECT_FALSE(at(100));
}

TEST_F(MissionControlTest, ForgivesABlockThatPasses) {
  const auto first = first_goal();
  hear(first.name, "blocked");
  (void)at(40);
  hear(first.name, "driving");
  (void)at(45);
  hear(first.name, "blocked");
  (void)at(90);
  EXPECT_EQ(progress().state, MissionControl::State::running);
}

TEST_F(MissionControlTest, AbortsAWaypointThatTakesTooLong) {
  hear(first_goal().name, "driving");
  (void)at(902);
  EXPECT_EQ(progress().state, MissionControl::State::running);
  (void)at(902.001);
  EXPECT_EQ(progress().state, MissionControl::State::aborted);
  EXPECT_THAT(progress().reason, ::testing::HasSubstr("not reached in time"));
}

TEST_F(MissionControlTest, SurvivesALongSilence) {
  hear(first_goal().name, "driving");
  for (double s = 3; s < 800; s += 1) (void)at(s);
  EXPECT_EQ(progress().state, MissionControl::State::running);
  hear(1);
  EXPECT_EQ(at(801).value().waypoint, 1U);
}

TEST(MissionControl, RefusesAMissionWithoutWaypoints) {
  EXPECT_THROW(MissionControl({}, Mission{}, 1), ConfigError);
}

TEST(MissionControl, RefusesALifetimeThatIsTooShortForTheRepetition) {
  MissionControl::Params params;
  params.repeat_after_s = 5;
  params.goal_lifetime_s = 10;
  EXPECT_THROW(MissionControl(params, two_waypoints, 1), ConfigError);
  params.goal_lifetime_s = 10.001;
  EXPECT_NO_THROW(MissionControl(params, two_waypoints, 1));
}

}  // namespace
}  // namespace tocsin
