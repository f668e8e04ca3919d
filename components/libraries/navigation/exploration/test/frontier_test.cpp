// SPDX-License-Identifier: Apache-2.0
#include "exploration/frontier.hpp"

#include <gtest/gtest.h>

#include "simulated_sight.hpp"

namespace tocsin::exploration {
namespace {

const navigation::InflationParams bare{0.05, 0, 0, 0};

std::vector<Frontier> frontiers_of(const std::vector<std::string>& rows,
                                   const geometry::Point& robot) {
  const auto map = drawn(rows);
  return find_frontiers(map, navigation::DistanceField(navigation::CostMap(map, bare), robot));
}

TEST(Frontiers, AreWhereKnownFloorEndsInTheUnknown) {
  const auto sut =
      frontiers_of({"#######", "#...???", "#...???", "#...???", "#######"}, {0.15, 0.25});
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_EQ(sut[0].cells.size(), 3U);
  EXPECT_NEAR(sut[0].length_m, 0.3, 1e-9);
  EXPECT_NEAR(sut[0].middle.x_m, 0.35, 1e-9);
  EXPECT_NEAR(sut[0].middle.y_m, 0.25, 1e-9);
}

TEST(Frontiers, ThatDoNotTouchAreSeveral) {
  const auto sut = frontiers_of({"#########", "#??...??#", "#??...??#", "#########"}, {0.45, 0.15});
  EXPECT_EQ(sut.size(), 2U);
}

TEST(Frontiers, BehindAWallOrAGapTooNarrowAreNone) {
  EXPECT_TRUE(frontiers_of({"########", "#..#..??", "########"}, {0.15, 0.15}).empty());
  const auto map = drawn(std::vector<std::string>(9, "........??"));
  const navigation::CostMap costs(map, {0.18, 0.07, 0, 0});
  EXPECT_EQ(find_frontiers(map, navigation::DistanceField(costs, {0.15, 0.45})).size(), 1U);
  auto cells = map.cells();
  for (const int row : {1, 7}) cells[map.grid().offset({5, row})] = navigation::Cell::occupied;
  for (const int row : {2, 6}) cells[map.grid().offset({5, row})] = navigation::Cell::occupied;
  const navigation::OccupancyMap narrow(map.grid(), cells);
  const navigation::CostMap narrow_costs(narrow, {0.18, 0.07, 0, 0});
  EXPECT_TRUE(
      find_frontiers(narrow, navigation::DistanceField(narrow_costs, {0.15, 0.45})).empty());
}

TEST(Frontiers, OfWhatIsKnownOrOfNothingAreNone) {
  EXPECT_TRUE(frontiers_of({"####", "#..#", "####"}, {0.15, 0.15}).empty());
  EXPECT_TRUE(frontiers_of({"????", "????", "????"}, {0.15, 0.15}).empty());
  EXPECT_TRUE(frontiers_of({"?"}, {0.05, 0.05}).empty());
}

}  // namespace
}  // namespace tocsin::exploration
