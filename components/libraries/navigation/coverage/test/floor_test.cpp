// SPDX-License-Identifier: Apache-2.0
#include "coverage/floor.hpp"

#include <gtest/gtest.h>

#include "coverage/covered_floor.hpp"
#include "coverage/polygon.hpp"
#include "floors.hpp"

namespace tocsin::coverage {
namespace {

TEST(ReachableFloor, IsWhatTheToolReachesFromWhereTheRobotCanBe) {
  const auto map = room(3, 2, 0, false);
  const navigation::CostMap costs(map, {});
  const Floor sut = reachable_floor(map, costs, {{0, 0}, {}}, 0.3);
  EXPECT_TRUE(sut.centres.has({1.2, 0}));
  EXPECT_FALSE(sut.centres.has({1.3, 0})) << "nearer to the wall than radius and margin";
  EXPECT_TRUE(sut.floor.has({1.36, 0}));
  EXPECT_FALSE(sut.floor.has({1.45, 0})) << "the tool does not reach the wall";
}

TEST(CoveredFloor, CountsWhatItPassesOnce) {
  const auto map = room(3, 2, 0, false);
  const Floor floor = reachable_floor(map, navigation::CostMap(map, {}), {{0, 0}, {}}, 0.3);
  CoveredFloor sut(floor.floor, 0.3);
  EXPECT_EQ(sut.share(), 0);
  const Swath swath{{-1, 0.02}, {1, 0.02}};
  const double gain_m2 = static_cast<double>(sut.gain(swath)) * 0.05 * 0.05;
  EXPECT_NEAR(gain_m2, 2 * 0.3 + 0.07, 0.12);
  EXPECT_EQ(sut.share(), 0) << "looking covers nothing";
  sut.drive(swath.from, swath.to);
  EXPECT_NEAR(sut.share(), gain_m2 / floor.floor.area_m2(), 1e-9);
  EXPECT_EQ(sut.gain(swath), 0U);
  EXPECT_FALSE(sut.uncovered().has({0, 0.02}));
  EXPECT_TRUE(sut.uncovered().has({0, 0.3}));
}

TEST(Polygon, HoldsWhatIsInside) {
  const std::vector<geometry::Point> hook{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}};
  EXPECT_TRUE(is_inside(hook, {1, 0.5}));
  EXPECT_TRUE(is_inside(hook, {2.5, 2}));
  EXPECT_FALSE(is_inside(hook, {1, 2}));
  EXPECT_EQ(error_of([&] { require_polygon(hook, "polygon"); }), "no error");
}

}  // namespace
}  // namespace tocsin::coverage
