// SPDX-License-Identifier: Apache-2.0
#include "navigator/goal_list.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin {
namespace {

constexpr Time t0{std::chrono::hours(1)};

/// Goal `id` at x = id, and as many ahead at x = id + 1, ...
Goal goal(std::uint64_t id, std::size_t ahead, double lifetime_s = 60) {
  const auto x = static_cast<double>(id);
  Goal goal{1, id, {{x, 0, 0}}, 0.15, t0 + seconds(lifetime_s), {}};
  for (std::size_t k = 1; k <= ahead; ++k)
    goal.ahead.push_back({{x + static_cast<double>(k), 0, 0}});
  return goal;
}

TEST(GoalList, AdvancesThroughWhatIsAheadAndNoFarther) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(5, 2), t0), GoalAnswer::accepted);
  EXPECT_TRUE(sut.advance());
  EXPECT_TRUE(sut.advance());
  EXPECT_EQ(sut.present()->id, 7U);
  EXPECT_EQ(sut.present()->pose.x_m, 7);
  EXPECT_FALSE(sut.advance());
  EXPECT_EQ(sut.present()->id, 7U);
}

TEST(GoalList, AGreaterIdSupersedesAllThatIsAhead) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(5, 2), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(goal(6, 0), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.present()->id, 6U);
  EXPECT_FALSE(sut.advance());
}

TEST(GoalList, AnEarlierGoalThatLeadsToThePresentOneRenewsIt) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(5, 2), t0), GoalAnswer::accepted);
  ASSERT_TRUE(sut.advance());
  EXPECT_EQ(sut.on_goal(goal(5, 3, 90), t0), GoalAnswer::renewed);
  EXPECT_EQ(sut.present()->id, 6U);
  EXPECT_EQ(sut.present()->expires, t0 + seconds(90));
  ASSERT_EQ(sut.present()->ahead.size(), 2U);
  EXPECT_EQ(sut.present()->ahead[0].x_m, 7);
}

TEST(GoalList, AnEarlierGoalThatEndsBeforeThePresentOneIsSuperseded) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(7, 2), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(goal(5, 1, 90), t0), GoalAnswer::superseded);
  EXPECT_EQ(sut.present()->expires, t0 + seconds(60));
  EXPECT_EQ(sut.on_goal(goal(5, 2, 90), t0), GoalAnswer::renewed);
  EXPECT_TRUE(sut.present()->ahead.empty());
}

TEST(GoalList, RefusesWhatIsNotFiniteAheadAndTooMuch) {
  GoalList sut;
  EXPECT_FALSE(sut.advance());
  Goal bad = goal(1, 2);
  bad.ahead[1].send_s = 3601;
  EXPECT_EQ(sut.on_goal(bad, t0), GoalAnswer::invalid);
  bad = goal(1, 2);
  bad.pose.send_s = -1;
  EXPECT_EQ(sut.on_goal(bad, t0), GoalAnswer::invalid);
  bad = goal(1, 2);
  bad.ahead[1].heading_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sut.on_goal(bad, t0), GoalAnswer::invalid);
  EXPECT_EQ(sut.on_goal(goal(1, 33), t0), GoalAnswer::invalid);
  EXPECT_FALSE(sut.present());
  EXPECT_EQ(sut.on_goal(goal(1, 32), t0), GoalAnswer::accepted);
}

constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

TEST(GoalList, TakesNoGoalBehindTheLargestId) {
  GoalList sut;
  EXPECT_EQ(sut.on_goal(goal(largest, 1), t0), GoalAnswer::invalid);
  EXPECT_EQ(sut.on_goal(goal(largest - 1, 1), t0), GoalAnswer::accepted);
  EXPECT_TRUE(sut.advance());
  EXPECT_EQ(sut.present()->id, largest);
  EXPECT_EQ(sut.on_goal(goal(1, 32), t0), GoalAnswer::superseded);
}

Goal of_mission(std::uint64_t mission, std::uint64_t id, std::size_t ahead = 0) {
  Goal made = goal(id, ahead);
  made.mission = mission;
  return made;
}

TEST(Missions, AGoalWithTheLargestIdDoesNotBlockAMissionThatComesAfterIt) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(of_mission(7, 3), t0), GoalAnswer::accepted);
  for (const std::uint64_t foreign : {std::uint64_t{7}, std::uint64_t{0}, largest}) {
    ASSERT_EQ(sut.on_goal(of_mission(foreign, largest), t0), GoalAnswer::accepted) << foreign;
  }
  EXPECT_EQ(sut.on_goal(of_mission(8, 3), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.present()->mission, 8U);
  EXPECT_EQ(sut.present()->id, 3U);
}

TEST(Missions, WhatStillComesOfAMissionThatIsOverIsRefused) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(of_mission(7, 3), t0), GoalAnswer::accepted);
  ASSERT_EQ(sut.on_goal(of_mission(8, 1), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(of_mission(7, 4), t0), GoalAnswer::superseded);
  EXPECT_EQ(sut.on_goal(of_mission(7, largest), t0), GoalAnswer::superseded);
  EXPECT_EQ(sut.present()->mission, 8U);
  ASSERT_EQ(sut.on_goal(of_mission(9, 1), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(of_mission(8, 2), t0), GoalAnswer::superseded);
  EXPECT_EQ(sut.on_goal(of_mission(7, 4), t0), GoalAnswer::superseded);
}

TEST(Missions, TheLastSixteenAreRemembered) {
  GoalList sut;
  for (std::uint64_t mission = 1; mission <= 17; ++mission) {
    ASSERT_EQ(sut.on_goal(of_mission(mission, 1), t0), GoalAnswer::accepted);
  }
  EXPECT_EQ(sut.on_goal(of_mission(1, 2), t0), GoalAnswer::superseded);
  ASSERT_EQ(sut.on_goal(of_mission(18, 1), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(of_mission(1, 2), t0), GoalAnswer::accepted);
}

TEST(Missions, ARefusedGoalOfANewMissionDoesNotEndTheOneBefore) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(of_mission(7, 3), t0), GoalAnswer::accepted);
  Goal late = of_mission(8, 1);
  late.expires = t0;
  EXPECT_EQ(sut.on_goal(late, t0), GoalAnswer::expired);
  EXPECT_EQ(sut.on_goal(of_mission(7, 4), t0), GoalAnswer::accepted);
}

TEST(GoalList, OneThatIsExpiredIsDrivenToNoMoreUntilItIsRenewed) {
  GoalList sut;
  sut.expire(t0);
  ASSERT_EQ(sut.on_goal(of_mission(7, 3, 2), t0), GoalAnswer::accepted);
  sut.expire(t0);
  EXPECT_EQ(sut.present()->expires, t0);
  EXPECT_TRUE(sut.present()->ahead.empty());
  EXPECT_EQ(sut.on_goal(of_mission(7, 3, 2), t0), GoalAnswer::renewed);
  EXPECT_GT(sut.present()->expires, t0);
}

TEST(Missions, EachPresentGoalHasANumberOfItsOwn) {
  GoalList sut;
  EXPECT_EQ(sut.present_number(), 0U);
  ASSERT_EQ(sut.on_goal(of_mission(7, 3, 1), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.present_number(), 1U);
  ASSERT_EQ(sut.on_goal(of_mission(7, 3, 1), t0), GoalAnswer::renewed);
  EXPECT_EQ(sut.present_number(), 1U);
  ASSERT_TRUE(sut.advance());
  EXPECT_EQ(sut.present_number(), 2U);
  ASSERT_EQ(sut.on_goal(of_mission(8, 4), t0), GoalAnswer::accepted);  // the same id
  EXPECT_EQ(sut.present_number(), 3U);
}

}  // namespace
}  // namespace tocsin
