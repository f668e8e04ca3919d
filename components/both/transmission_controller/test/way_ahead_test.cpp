// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/way_ahead.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin {
namespace {

using geometry::Point;

constexpr Time t0{std::chrono::hours(1)};

/// The risk of a place is its x [%].
navigation::LinkRisk by_x() {
  const navigation::Grid grid{100, 10, 1, {0, 0}};
  std::vector<std::int8_t> percent;
  for (int i = 0; i < 1000; ++i) percent.push_back(static_cast<std::int8_t>(i % 100));
  return {grid, percent};
}

class WayAheadTest : public ::testing::Test {
 protected:
  WayAheadTest() {
    sut_.set_risk(by_x());
    sut_.set_plan({{10.5, 5}, {20.5, 5}, {20.5, 7}});
  }
  [[nodiscard]] std::vector<int> at(const Point& place, Time now = t0) {
    sut_.set_place(place, now);
    const auto outlook = sut_.outlook(now);
    return {outlook.risk_percent.begin(), outlook.risk_percent.begin() + outlook.size};
  }
  WayAhead sut_{0.5};
};

TEST_F(WayAheadTest, FollowsThePlanAtItsSpeedAndStaysAtItsEnd) {
  const auto risks = at({12.5, 5.3});
  ASSERT_EQ(risks.size(), decision::Outlook::most);
  EXPECT_EQ(risks[0], 12);
  EXPECT_EQ(risks[2], 13) << "a metre in two seconds";
  EXPECT_EQ(risks[10], 17);
  EXPECT_EQ(risks[16], 20);
  EXPECT_EQ(risks[60], 20);
}

TEST_F(WayAheadTest, NothingIsForeseenBesideThePlanOrWithoutOne) {
  EXPECT_TRUE(at({12.5, 6.2}).empty());
  EXPECT_TRUE(at({5, 5}).empty()) << "before its start";
  sut_.set_plan({});
  EXPECT_TRUE(at({12.5, 5}).empty());
  sut_.set_plan({{10.5, 5}, {std::nan(""), 5}});
  EXPECT_TRUE(at({12.5, 5}).empty());
}

TEST_F(WayAheadTest, NothingIsForeseenWithoutAMapOrAPlace) {
  WayAhead blind(0.5);
  blind.set_plan({{0, 0}, {9, 0}});
  blind.set_place({1, 0}, t0);
  EXPECT_EQ(blind.outlook(t0).size, 0U);
  EXPECT_EQ(sut_.outlook(t0).size, 0U);
  sut_.set_place({std::nan(""), 5}, t0);
  EXPECT_EQ(sut_.outlook(t0).size, 0U);
  (void)at({12.5, 5});
  EXPECT_EQ(sut_.outlook(t0 + std::chrono::milliseconds(2100)).size, 0U) << "it is old";
}

TEST_F(WayAheadTest, AVehicleThatStandsStaysThere) {
  for (int s = 0; s < 5; ++s) (void)at({12.5, 5}, t0 + std::chrono::seconds(s));
  const auto risks = at({12.5, 5}, t0 + std::chrono::seconds(5));
  ASSERT_EQ(risks.size(), decision::Outlook::most);
  EXPECT_EQ(risks[60], 12);
  EXPECT_EQ(at({13.5, 5}, t0 + std::chrono::seconds(6))[60], 20) << "it drives again";
}

}  // namespace
}  // namespace tocsin
