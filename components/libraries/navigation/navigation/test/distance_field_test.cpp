// SPDX-License-Identifier: Apache-2.0
#include "navigation/distance_field.hpp"

#include <gtest/gtest.h>

#include "drawn_map.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::navigation {
namespace {

const InflationParams bare{0.1, 0, 0, 0};

TEST(DistanceField, GoesRoundWallsAndNotThroughThem) {
  const CostMap map(
      drawn_map({"#######", "#..#..#", "#..#..#", "#.....#", "####..#", "#.#...#", "#######"}),
      bare);
  const DistanceField sut(map, {1.5, 5.5});
  EXPECT_DOUBLE_EQ(sut.distance_m({1.5, 5.5}), 0);
  EXPECT_NEAR(sut.distance_m({2.5, 4.5}), 1.4, 1e-9);
  EXPECT_NEAR(sut.distance_m({4.5, 5.5}), 2 + 3 + 2 - 0.6, 1e-9) << "a corner cannot be cut";
  EXPECT_EQ(sut.distance_m({1.5, 1.5}), infinity) << "walled in";
  EXPECT_EQ(sut.distance_m({3.5, 5.5}), infinity) << "a wall";
  EXPECT_EQ(sut.distance_m({-1, 0}), infinity) << "outside of the map";
}

TEST(DistanceField, ReachesNothingFromAStartThatIsNone) {
  const CostMap map(drawn_map({"####", "#..#", "####"}), bare);
  for (const geometry::Point& start : {geometry::Point{nan, 1}, {9, 9}, {1.5, infinity}}) {
    const DistanceField sut(map, start);
    EXPECT_EQ(sut.distance_m({1.5, 1.5}), infinity);
  }
}

TEST(DistanceField, DearFloorCountsAsLonger) {
  const OccupancyMap floor = drawn_map({"#########", "........#", "........#", "........#"}, 0.2);
  const double plain_m =
      DistanceField(CostMap(floor, bare), {0.3, 0.3}).distance_m(geometry::Point{1.3, 0.3});
  const double dear_m = DistanceField(CostMap(floor, {0.1, 0, 1, 5}), {0.3, 0.3})
                            .distance_m(geometry::Point{1.3, 0.3});
  EXPECT_NEAR(plain_m, 1, 1e-6);
  EXPECT_GT(dear_m, 1.5);
}

}  // namespace
}  // namespace tocsin::navigation
