// SPDX-License-Identifier: Apache-2.0
#include "localisation/distance_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::localisation {
namespace {

using navigation::Cell;
using navigation::Grid;

TEST(DistanceMap, IsWhatComparingWithEveryWallGives) {
  std::mt19937 random(5);
  const Grid grid{60, 40, 0.05, {-1, 2}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int i = 0; i < 30; ++i) cells[random() % cells.size()] = Cell::occupied;
  const DistanceMap sut(navigation::OccupancyMap(grid, cells));
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      double nearest_m = DistanceMap::most_m;
      for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
        if (cells[static_cast<std::size_t>(i)] != Cell::occupied) continue;
        nearest_m =
            std::min(nearest_m, 0.05 * std::hypot(i % grid.width - column, i / grid.width - row));
      }
      EXPECT_NEAR(sut.nearest_m(grid.centre({column, row})), nearest_m, 1e-6);
    }
  }
}

TEST(DistanceMap, SlopesTowardsTheWallAndIsFlatOutside) {
  const Grid grid{40, 40, 0.05, {0, 0}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int row = 0; row < 40; ++row) cells[grid.offset({20, row})] = Cell::occupied;
  const DistanceMap sut(navigation::OccupancyMap(grid, cells));
  const auto sample = sut.sample({0.81, 1});
  EXPECT_NEAR(sample.distance_m, 1.025 - 0.81, 1e-6);
  EXPECT_NEAR(sample.dx, -1, 1e-5);
  EXPECT_NEAR(sample.dy, 0, 1e-5);
  for (const geometry::Point& p : {geometry::Point{-1, 1}, {3, 1}, {1, 9}, {nan, 1}}) {
    EXPECT_EQ(sut.sample(p).distance_m, DistanceMap::most_m);
    EXPECT_EQ(sut.sample(p).dx, 0);
    EXPECT_EQ(sut.nearest_m(p), DistanceMap::most_m);
  }
}

TEST(DistanceMap, OfAnEmptyFloorIsFarEverywhere) {
  const Grid grid{10, 10, 0.05, {0, 0}};
  const DistanceMap sut(navigation::OccupancyMap(grid, std::vector<Cell>(100, Cell::free)));
  EXPECT_EQ(sut.nearest_m({0.2, 0.2}), DistanceMap::most_m);
}

}  // namespace
}  // namespace tocsin::localisation
