// SPDX-License-Identifier: Apache-2.0
#include "navigator/send_stop.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tocsin {
namespace {

using navigation::Grid;
using navigation::LinkRisk;

constexpr Time t0{std::chrono::hours(1)};
constexpr double speed_mps = 0.5;

/// 20 m along x: of each metre the chance in percent that the link is lost.
LinkRisk link(const std::vector<std::int8_t>& percent) {
  return {Grid{static_cast<int>(percent.size()), 1, 1.0, {0, -0.5}}, percent};
}
LinkRisk lost_from(std::size_t metre) {
  std::vector<std::int8_t> percent(20, 10);
  for (std::size_t i = metre; i < percent.size(); ++i) percent[i] = 90;
  return link(percent);
}

class SendStopTest : public ::testing::Test {
 protected:
  static SendStop::Params with(double send_stop_s) {
    SendStop::Params params;
    params.send_stop_s = send_stop_s;
    return params;
  }
  /// A second passes; the router says that so many wait, and so many more have crossed.
  void second(std::uint64_t waiting, std::uint64_t crossed = 0) {
    now_ += std::chrono::seconds(1);
    crossed_ += crossed;
    sut_.on_store({waiting, crossed_}, now_);
  }
  bool stands_at(double x_m, const LinkRisk& risk, std::uint64_t goal = 1) {
    return sut_.stands_on_way(goal, {{x_m, 0}, {19.5, 0}}, speed_mps, risk, now_);
  }

  SendStop sut_{with(60)};
  Time now_ = t0;
  std::uint64_t crossed_ = 0;
};

TEST_F(SendStopTest, StandsWhereTheLinkIsLostBeforeAllHasCrossed) {
  second(100);
  second(90, 10);  // 9 s are needed
  EXPECT_FALSE(stands_at(1, lost_from(20))) << "the link is never lost";
  EXPECT_FALSE(stands_at(1, lost_from(10))) << "18 s of link are ahead";
  EXPECT_TRUE(stands_at(1, lost_from(4))) << "6 s are ahead";
}

TEST_F(SendStopTest, DrivesOnWhenAllHasCrossed) {
  second(100);
  second(90, 10);
  ASSERT_TRUE(stands_at(1, lost_from(4)));
  second(40, 50);
  EXPECT_TRUE(stands_at(1, lost_from(4)));
  second(2, 38);
  EXPECT_FALSE(stands_at(1, lost_from(4)));
  second(1000);
  EXPECT_FALSE(stands_at(1, lost_from(4))) << "once on the way to a goal";
  EXPECT_TRUE(stands_at(1, lost_from(4), 2));
}

TEST_F(SendStopTest, DrivesToTheBestPlaceBeforeTheLinkIsLost) {
  second(1000);
  std::vector<std::int8_t> percent(20, 90);
  for (const std::size_t metre : {0U, 1U, 2U}) percent[metre] = 15;
  percent[3] = 2;
  EXPECT_FALSE(stands_at(0.5, link(percent)));
  EXPECT_TRUE(stands_at(3.2, link(percent)));
}

TEST_F(SendStopTest, DoesNotStandWhereTheLinkIsPoor) {
  second(1000);
  EXPECT_FALSE(stands_at(1, link({30, 30, 30, 90, 90})));
}

TEST_F(SendStopTest, GivesUpWhereNothingCrosses) {
  second(100);
  ASSERT_TRUE(stands_at(1, lost_from(4)));
  int stood_s = 0;
  for (; stands_at(1, lost_from(4)); ++stood_s) second(100);
  EXPECT_EQ(stood_s, 10);
}

TEST_F(SendStopTest, GivesUpWhereLessThanHalfOfTheUsualCrosses) {
  second(200);
  second(180, 20);
  ASSERT_TRUE(stands_at(1, lost_from(4)));
  int stood_s = 0;
  for (; stands_at(1, lost_from(4)); ++stood_s) second(170, stood_s < 10 ? 11 : 9);
  EXPECT_EQ(stood_s, 20);
}

TEST_F(SendStopTest, DoesNotStandForLongerThanItMay) {
  second(10000);
  int stood_s = 0;
  for (; stands_at(1, lost_from(4)); ++stood_s) second(10000, 5);
  EXPECT_EQ(stood_s, 60);
}

TEST_F(SendStopTest, KnowsNothingOfAStoreThatIsNotTold) {
  EXPECT_FALSE(stands_at(1, lost_from(4)));
  second(100);
  EXPECT_TRUE(stands_at(1, lost_from(4)));
  now_ += std::chrono::milliseconds(5001);
  EXPECT_FALSE(stands_at(1, lost_from(4)));
}

TEST_F(SendStopTest, IsOffByDefault) {
  SendStop sut{{}};
  sut.on_store({100, 0}, now_);
  EXPECT_FALSE(sut.stands_on_way(1, {{1, 0}, {19.5, 0}}, speed_mps, lost_from(4), now_));
}

TEST_F(SendStopTest, StandsAtAGoalUntilAllHasCrossedOrItsTimeIsOver) {
  second(100);
  EXPECT_FALSE(sut_.stands_at_goal(1, 0, now_));
  EXPECT_TRUE(sut_.stands_at_goal(1, 5, now_));
  for (int i = 0; i < 4; ++i) second(100, 10);
  EXPECT_TRUE(sut_.stands_at_goal(1, 5, now_));
  second(100, 10);
  EXPECT_FALSE(sut_.stands_at_goal(1, 5, now_));
  EXPECT_TRUE(sut_.stands_at_goal(2, 5, now_));
  second(1, 99);
  EXPECT_TRUE(sut_.stands_at_goal(2, 5, now_)) << "one picture may be the one that counts";
  second(0, 1);
  EXPECT_FALSE(sut_.stands_at_goal(2, 5, now_));
}

TEST_F(SendStopTest, ARestartedRouterCountsFromZero) {
  second(100, 50);
  ASSERT_TRUE(sut_.stands_at_goal(1, 30, now_));
  crossed_ = 0;
  for (int i = 0; i < 12; ++i) {
    second(100, 1);
    EXPECT_TRUE(sut_.stands_at_goal(1, 30, now_)) << i;
  }
}

}  // namespace
}  // namespace tocsin
