// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "mission_control_fixture.hpp"

namespace tocsin {
namespace {

using navigation::Mission;

TEST_F(MissionControlTest, TellsTheWaypointsAheadAndTheirIds) {
  const auto first = first_goal();
  ASSERT_EQ(first.ahead.size(), 1U);
  EXPECT_EQ(first.ahead[0].x_m, 5);
  EXPECT_EQ(first.name.id, 1U);
  hear(1);
  const auto second = at(3).value();
  EXPECT_EQ(second.name.mission, first.name.mission);
  EXPECT_EQ(second.name.id, 2U);
  EXPECT_TRUE(second.ahead.empty());
}

TEST_F(MissionControlTest, WhereTheVehicleSendsItsWordAloneIsArrival) {
  sut.lead({"sends", "map", {{{1, 0, 0}, 30}, {{5, 0, 0}, 60}}, ""});
  const auto first = first_goal();
  EXPECT_EQ(first.pose.send_s, 30);
  EXPECT_EQ(first.ahead.at(0).send_s, 60);
  hear(1);
  hear(first.name, "held");
  (void)at(3);
  EXPECT_EQ(progress().waypoint, 0U);
  hear(first.name, "reached");
  (void)at(4);
  EXPECT_EQ(progress().waypoint, 1U);
}

TEST_F(MissionControlTest, TellsNoMoreAheadThanItIsTold) {
  const Mission five{
      "five", "map", {{{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}}, {{4, 0, 0}}, {{5, 0, 0}}}, ""};
  for (const int ahead : {0, 3, 4, 5}) {
    MissionControl::Params params;
    params.goals_ahead = ahead;
    MissionControl control(params, five, 1);
    control.on_location({-5, 0, 0}, t0);
    const auto goal = control.update(t0 + seconds(2)).value();
    EXPECT_EQ(goal.ahead.size(), static_cast<std::size_t>(std::min(ahead, 4)));
  }
}

TEST_F(MissionControlTest, FollowsAVehicleThatHasGoneOnByItself) {
  const auto first = first_goal();
  hear(after(first.name), "driving");
  const auto second = at(2.1).value();  // renews the lease and tells what is ahead of it
  EXPECT_EQ(second.name.id, 2U);
  EXPECT_EQ(second.name.mission, first.name.mission);
  EXPECT_EQ(progress().waypoint, 1U);
  ASSERT_EQ(sut.arrivals().size(), 1U);
  EXPECT_FALSE(sut.arrivals()[0].by_location);
  hear(second.name, "reached");
  (void)at(3);
  EXPECT_EQ(progress().state, MissionControl::State::done);
}

/// A mission control that is started while the vehicle drives.
class SuccessorTest : public MissionControlTest {
 protected:
  /// Its first goal, when the vehicle tells of `goal`.
  MissionControl::Goal goal_after(const GoalName& goal, const char* state,
                                  const Mission& mission = two_waypoints, bool resume = true) {
    MissionControl::Params params;
    params.resume = resume;
    MissionControl anew(params, mission, 2);
    anew.on_status(goal, state, now_);
    return anew.update(now_).value();
  }
};

TEST_F(SuccessorTest, GoesOnWhereAnEarlierOneWas) {
  const auto first = first_goal();
  for (const std::uint64_t id : {1U, 2U}) {
    const auto renewed = goal_after({first.name.mission, id}, "driving");
    EXPECT_EQ(renewed.waypoint, id - 1);
    EXPECT_EQ(renewed.name.id, id);
    EXPECT_EQ(renewed.name.mission, first.name.mission);
  }
}

TEST_F(SuccessorTest, GoesOnBehindAWaypointThatWasReachedMeanwhile) {
  EXPECT_EQ(goal_after(first_goal().name, "reached").waypoint, 1U);
}

TEST_F(SuccessorTest, StartsOverForAnotherMissionAForeignGoalOrWhenToldNotToResume) {
  const auto first = first_goal();
  const Mission other{"other", "map", {{{9, 9, 0}}, {{8, 8, 0}}}, ""};
  for (const auto& goal : {goal_after(after(first.name), "driving", other),
                           goal_after(after(first.name, 2), "driving"),  // none of its waypoints
                           goal_after(after(first.name), "driving", two_waypoints, false)}) {
    EXPECT_EQ(goal.waypoint, 0U);
    EXPECT_NE(goal.name.mission, first.name.mission);
  }
}

/// The vehicle drives to a goal that is not this mission control's.
class TakenOverTest : public MissionControlTest {
 protected:
  static constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  const MissionControl::Goal first_ = first_goal();
};

TEST_F(TakenOverTest, BeginsAMissionOfItsOwnAnewWhateverTheNumbers) {
  std::set<std::uint64_t> identities{first_.name.mission};
  double s = 2.5;
  for (const GoalName& foreign :
       {GoalName{7, 1}, GoalName{largest, largest}, GoalName{0, largest}}) {
    (void)at(s);
    hear(foreign, "driving");
    const auto again = at(s + 3);
    ASSERT_TRUE(again) << foreign.mission << ' ' << foreign.id;
    EXPECT_EQ(again->waypoint, 0U);
    EXPECT_EQ(again->name.id, 1U);
    EXPECT_TRUE(identities.insert(again->name.mission).second);
    s += 3.5;
  }
}

TEST_F(TakenOverTest, BeginsAnewAfterADamagedGoalOfItsOwnMission) {
  (void)at(2.5);
  hear({first_.name.mission, largest}, "driving");
  EXPECT_NE(at(5).value().name.mission, first_.name.mission);
}

TEST_F(TakenOverTest, DoesSoOnlyWhenTheVehicleSaysItAfterItsGoal) {
  hear({7, 1}, "driving");  // in the instant in which the goal was sent: does not know it yet
  EXPECT_TRUE(at(5).value().name.mission == first_.name.mission);
}

TEST_F(TakenOverTest, TakesAnAnswerToItsOwnEarlierGoalForNothingNew) {
  (void)at(2.5);
  hear({7, 1}, "driving");
  const auto second = at(5).value();
  (void)at(5.1);
  hear(first_.name, "driving");  // was on its way
  const auto third = at(8).value();
  EXPECT_EQ(third.name.mission, second.name.mission);
}

TEST_F(TakenOverTest, KeepsItsIdentityWhileTheVehicleIsSilentOrForgetsItsGoal) {
  EXPECT_EQ(at(5).value().name.mission, first_.name.mission);
  hear(GoalName{}, "idle");
  (void)at(5.1);
  EXPECT_EQ(at(8).value().name.mission, first_.name.mission);
}

TEST_F(TakenOverTest, ADriveToAnotherMissionsGoalIsNoProgressOfThisOne) {
  (void)at(2.5);
  hear({7, 2}, "reached");
  (void)at(3);
  EXPECT_EQ(progress().waypoint, 0U);
  EXPECT_EQ(progress().state, MissionControl::State::running);
}

TEST(MissionControl, DrawsAnotherIdentityFromEachSeed) {
  std::set<std::uint64_t> identities;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    MissionControl sut({}, two_waypoints, seed);
    sut.on_location({-5, 0, 0}, t0);
    identities.insert(sut.update(t0 + seconds(2)).value().name.mission);
  }
  EXPECT_EQ(identities.size(), 1000U);
}

}  // namespace
}  // namespace tocsin
