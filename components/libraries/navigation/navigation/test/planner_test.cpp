// SPDX-License-Identifier: Apache-2.0
#include "navigation/planner.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "drawn_map.hpp"

namespace tocsin::navigation {
namespace {

const InflationParams no_inflation{0.0, 0.0, 0.0, 0.0};

/// A floor of 8 m x 4 m, 0.05 m cells, with a wall at x = 4 that leaves the top `gap_m` open.
OccupancyMap floor_with_wall(double gap_m) {
  const Grid grid{160, 80, 0.05, {0, 0}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int row = 0; row < 80 - static_cast<int>(gap_m / 0.05); ++row) {
    cells[grid.offset({80, row})] = Cell::occupied;
  }
  return {grid, cells};
}

double clearance_m(const OccupancyMap& map, const geometry::Path& path) {
  double least_m = 10;
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (double t = 0; t <= 1; t += 0.01) {
      const geometry::Point p = between(path[i - 1], path[i], t);
      while (map.collides(p.x_m, p.y_m, least_m)) least_m -= 0.005;
    }
  }
  return least_m;
}

void expect_equal(const std::optional<geometry::Path>& path,
                  const std::optional<geometry::Path>& other) {
  ASSERT_EQ(path.has_value(), other.has_value());
  if (!path) return;
  ASSERT_EQ(path->size(), other->size());
  for (std::size_t i = 0; i < path->size(); ++i) {
    EXPECT_EQ((*path)[i].x_m, (*other)[i].x_m);
    EXPECT_EQ((*path)[i].y_m, (*other)[i].y_m);
  }
}

TEST(CostMap, BlocksRadiusAndMarginAroundAWall) {
  const CostMap sut(floor_with_wall(1), {0.18, 0.07, 0.6, 3});
  EXPECT_TRUE(sut.blocked(geometry::Point{4.025, 1}));
  EXPECT_TRUE(sut.blocked(geometry::Point{4.275, 1}));
  EXPECT_FALSE(sut.blocked(geometry::Point{4.325, 1}));
}

TEST(CostMap, FallsToThePlainCostAtTheSoftRadius) {
  const CostMap sut(floor_with_wall(1), {0.18, 0.07, 0.6, 3});
  const auto cost_at = [&](double x) {
    return sut.cost(sut.grid().offset(*sut.grid().cell_of({x, 1})));
  };
  EXPECT_GT(cost_at(4.325), cost_at(4.425));
  EXPECT_GT(cost_at(4.325), 3 * CostMap::plain);
  EXPECT_EQ(cost_at(4.675), CostMap::plain);
}

TEST(CostMap, BlocksUnknownCellsAndTheOutside) {
  const CostMap sut(drawn_map({"....", ".?..", "...."}), no_inflation);
  EXPECT_FALSE(sut.blocked(geometry::Point{2.5, 1.5}));
  EXPECT_TRUE(sut.blocked(geometry::Point{1.5, 1.5}));
  EXPECT_TRUE(sut.blocked(geometry::Point{3.5, 1.5}));
  EXPECT_TRUE(sut.blocked(geometry::Point{4.5, 1.5}));
  EXPECT_TRUE(sut.blocked(CellIndex{-1, 0}));
}

TEST(CostMap, InflatesASolidBlockLikeItsRim) {
  const auto map =
      drawn_map({"........", "........", "...###..", "...###..", "...###..", "........"});
  const CostMap sut(map, {1.0, 0.0, 0.0, 0.0});
  EXPECT_TRUE(sut.blocked(geometry::Point{4.5, 2.5}));
  EXPECT_TRUE(sut.blocked(geometry::Point{2.5, 2.5}));
  EXPECT_FALSE(sut.blocked(geometry::Point{1.5, 2.5}));
}

TEST(Plan, IsAStraightLineBetweenTheExactPointsInTheOpen) {
  const CostMap map(open_floor(200, 100), {});
  const auto path = plan(map, {1.013, 1.027}, {8.03, 3.33});
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 2u);
  EXPECT_DOUBLE_EQ(path->front().x_m, 1.013);
  EXPECT_DOUBLE_EQ(path->back().y_m, 3.33);
}

TEST(Plan, GoesRoundAWallWithClearance) {
  const auto floor = floor_with_wall(1.2);
  const auto path = plan(CostMap(floor, {}), {3, 0.5}, {5, 0.5});
  ASSERT_TRUE(path);
  EXPECT_GT(length_m(*path), 2 * 2.3);
  EXPECT_LT(length_m(*path), 9);
  EXPECT_GT(clearance_m(floor, *path), 0.2);
}

TEST(Plan, PrefersTheMiddleOfAGap) {
  const auto floor = floor_with_wall(1.2);
  InflationParams soft;
  soft.soft_weight = 10;
  const auto wide = plan(CostMap(floor, soft), {3, 2.8}, {5, 2.8});
  soft.soft_weight = 0;
  const auto near = plan(CostMap(floor, soft), {3, 2.8}, {5, 2.8});
  ASSERT_TRUE(wide && near);
  EXPECT_GT(clearance_m(floor, *wide), clearance_m(floor, *near) + 0.05);
}

TEST(Plan, FindsNoWayThroughAGapThatIsTooNarrow) {
  EXPECT_TRUE(plan(CostMap(floor_with_wall(0.45), {}), {3, 0.5}, {5, 0.5}));
  EXPECT_FALSE(plan(CostMap(floor_with_wall(0.2), {}), {3, 0.5}, {5, 0.5}));
}

TEST(Plan, DoesNotSqueezeBetweenDiagonalWalls) {
  const CostMap map(drawn_map({".......", "...#...", "...#...", ".##....", ".......", "......."}),
                    no_inflation);
  ASSERT_FALSE(map.blocked(geometry::Point{1.5, 3.5}) || map.blocked(geometry::Point{4.5, 1.5}));
  EXPECT_FALSE(plan(map, {1.5, 3.5}, {4.5, 1.5}));
}

TEST(Plan, LeavesAStartThatIsTooNearToAWall) {
  const CostMap map(floor_with_wall(1.2), {});
  ASSERT_TRUE(map.blocked(geometry::Point{4.15, 1}));
  const auto path = plan(map, {4.15, 1}, {6, 1});
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->front().x_m, 4.15);
  EXPECT_GE(path->size(), 3u);
}

TEST(Plan, MovesAGoalOnlyALittleOffAWall) {
  const CostMap map(floor_with_wall(1.2), {});
  const auto path = plan(map, {6, 1}, {4.2, 1});
  ASSERT_TRUE(path);
  EXPECT_LT(distance(path->back(), {4.2, 1}), 0.15);
  EXPECT_FALSE(plan(map, {6, 1}, {4.1, 1}));
}

TEST(Plan, FindsNothingOutsideTheMapOrForNan) {
  const CostMap map(open_floor(40, 40), {});
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(plan(map, {1, 1}, {3, 1}));
  EXPECT_FALSE(plan(map, {-1, 1}, {1, 1}));
  EXPECT_FALSE(plan(map, {nan, 1}, {1, 1}));
  EXPECT_FALSE(plan(map, {1, 1}, {1, nan}));
}

TEST(Planner, PlansAsIfItHadPlannedNothingBefore) {
  auto floor = floor_with_wall(1.2);
  std::vector<Cell> cells = floor.cells();
  for (int row = 0; row < 80; ++row) cells[floor.grid().offset({130, row})] = Cell::occupied;
  const CostMap map({floor.grid(), cells}, {});
  Planner sut(std::make_shared<const CostMap>(map));
  const std::vector<geometry::Point> places{{3, 0.5}, {5, 0.5}, {1, 3},
                                            {7.5, 2}, {5.5, 3}, {0.5, 0.5}};
  for (const geometry::Point& start : places) {
    for (const geometry::Point& goal : places) {
      expect_equal(sut.plan(start, goal), plan(map, start, goal));  // none over the second wall
    }
  }
}

TEST(Plan, IsNotLongerThanTheShortestPathRoundTheCorner) {
  const auto path = plan(CostMap(floor_with_wall(1.0), {0.18, 0.07, 0.0, 0.0}), {3, 2}, {5, 2});
  ASSERT_TRUE(path);
  const double shortest_m =
      geometry::distance({3, 2}, {3.8, 3.2}) + 0.45 + geometry::distance({4.25, 3.2}, {5, 2});
  EXPECT_LT(length_m(*path), shortest_m * 1.05);
}

}  // namespace
}  // namespace tocsin::navigation
