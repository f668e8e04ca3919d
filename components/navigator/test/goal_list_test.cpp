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
  Goal goal{id, {x, 0, 0}, 0.15, t0 + seconds(lifetime_s), {}};
  for (std::size_t k = 1; k <= ahead; ++k) goal.ahead.push_back({x + static_cast<double>(k), 0, 0});
  return goal;
}

TEST(GoalList, IsEmptyBeforeTheFirstGoal) {
  GoalList sut;
  EXPECT_FALSE(sut.present());
  EXPECT_FALSE(sut.advance());
}

TEST(GoalList, AdvancesThroughWhatIsAheadAndNoFarther) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(5, 2), t0), GoalAnswer::accepted);
  EXPECT_TRUE(sut.advance());
  EXPECT_TRUE(sut.advance());
  EXPECT_EQ(sut.present()->id, 7U);
  EXPECT_EQ(sut.present()->pose.x, 7);
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
  EXPECT_EQ(sut.present()->ahead[0].x, 7);
}

TEST(GoalList, AnEarlierGoalThatEndsBeforeThePresentOneIsSuperseded) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(7, 2), t0), GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(goal(5, 1, 90), t0), GoalAnswer::superseded);
  EXPECT_EQ(sut.present()->expires, t0 + seconds(60));
  EXPECT_EQ(sut.on_goal(goal(5, 2, 90), t0), GoalAnswer::renewed);
  EXPECT_TRUE(sut.present()->ahead.empty());
}

TEST(GoalList, RefusesMoreAheadThanTheLimit) {
  GoalList sut;
  EXPECT_EQ(sut.on_goal(goal(1, 33), t0), GoalAnswer::invalid);
  EXPECT_EQ(sut.on_goal(goal(1, 32), t0), GoalAnswer::accepted);
}

TEST(GoalList, RefusesWhatIsNotFiniteAhead) {
  GoalList sut;
  Goal bad = goal(1, 2);
  bad.ahead[1].yaw = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sut.on_goal(bad, t0), GoalAnswer::invalid);
  EXPECT_FALSE(sut.present());
}

TEST(GoalList, SurvivesTheGreatestId) {
  GoalList sut;
  ASSERT_EQ(sut.on_goal(goal(std::numeric_limits<std::uint64_t>::max(), 1), t0),
            GoalAnswer::accepted);
  EXPECT_EQ(sut.on_goal(goal(1, 32), t0), GoalAnswer::superseded);
}

}  // namespace
}  // namespace tocsin
