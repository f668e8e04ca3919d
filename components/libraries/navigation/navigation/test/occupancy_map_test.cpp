// SPDX-License-Identifier: Apache-2.0
#include "navigation/occupancy_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_map.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::navigation {
namespace {

const OccupancyMap room = drawn_map({"######",  //
                                     "#....#",  //
                                     "#..?.#",  //
                                     "#....#",  //
                                     "######"});

TEST(Grid, FindsTheCellOfAPoint) {
  const Grid sut{10, 5, 0.05, {-1, 2}};
  for (const geometry::Point& point : {geometry::Point{-0.89, 2.06}, sut.centre({2, 1})}) {
    const auto cell = sut.cell_of(point);
    ASSERT_TRUE(cell);
    EXPECT_EQ(cell->column, 2);
    EXPECT_EQ(cell->row, 1);
  }
}

TEST(Grid, HasNoCellOutsideOrForNan) {
  const Grid sut{10, 5, 1, {0, 0}};
  EXPECT_TRUE(sut.cell_of({0, 0}));
  EXPECT_FALSE(sut.cell_of({-0.001, 0}));
  EXPECT_TRUE(sut.cell_of({9.999, 4.999}));
  EXPECT_FALSE(sut.cell_of({10, 4}));
  EXPECT_FALSE(sut.cell_of({1, 5}));
  EXPECT_FALSE(sut.cell_of({nan, 1}));
  EXPECT_FALSE(sut.cell_of({1e300, 1}));
}

TEST(OccupancyMap, TellsWhatIsAtAPlace) {
  EXPECT_EQ(room.at(geometry::Point{1.5, 1.5}), Cell::free);
  EXPECT_EQ(room.at(geometry::Point{0.5, 1.5}), Cell::occupied);
  EXPECT_EQ(room.at(geometry::Point{3.5, 2.5}), Cell::unknown);
  EXPECT_EQ(room.at(geometry::Point{-1, 1}), Cell::unknown) << "outside";
}

TEST(Raycast, MeasuresTheDistanceToTheWallInAllDirections) {
  EXPECT_NEAR(room.raycast({2.5, 1.5}, 0, 10).value(), 2.5, 1e-9);
  EXPECT_NEAR(room.raycast({2.5, 1.5}, -pi / 2, 10).value(), 0.5, 1e-9);
  EXPECT_NEAR(room.raycast({2.5, 1.75}, -pi / 4, 10).value(), 0.75 * std::sqrt(2), 1e-9);
  for (double bearing_rad = -3.1; bearing_rad < 3.1; bearing_rad += 0.1) {
    double walked_m = 0;
    const auto at = [&] {
      return geometry::Point{1.3 + walked_m * std::cos(bearing_rad),
                             2.2 + walked_m * std::sin(bearing_rad)};
    };
    while (room.at(at()) != Cell::occupied) walked_m += 1e-4;
    EXPECT_NEAR(room.raycast({1.3, 2.2}, bearing_rad, 10).value(), walked_m, 2e-4) << bearing_rad;
  }
}

TEST(Raycast, EndsAtItsRangeAndAtTheBorderOfTheMap) {
  EXPECT_TRUE(room.raycast({2.5, 1.5}, 0, 2.51));
  EXPECT_FALSE(room.raycast({2.5, 1.5}, 0, 2.49));
  EXPECT_FALSE(drawn_map({"...", "..."}).raycast({1.5, 0.5}, 0.3, 1e9));
  EXPECT_DOUBLE_EQ(room.raycast({0.5, 0.5}, 1, 10).value(), 0) << "inside of a wall";
  EXPECT_NEAR(room.raycast({2.5, 2.5}, 0, 10).value(), 2.5, 1e-9) << "unknown does not stop it";
}

TEST(Raycast, SeesNothingFromOutsideOrWithNan) {
  EXPECT_FALSE(room.raycast({-5, 1.5}, 0, 100));
  EXPECT_FALSE(room.raycast({2.5, 1.5}, nan, 10));
  EXPECT_FALSE(room.raycast({nan, 1.5}, 0, 10));
  EXPECT_FALSE(room.raycast({2.5, 1.5}, 0, nan));
}

TEST(Collides, TouchesWallAndCornerAtExactlyTheRadius) {
  EXPECT_FALSE(room.collides(1.5, 2.5, 0.49));
  EXPECT_TRUE(room.collides(1.5, 2.5, 0.51));
  const auto sut = drawn_map({"...", ".#.", "..."});
  EXPECT_FALSE(sut.collides(0.5, 0.5, 0.70));
  EXPECT_TRUE(sut.collides(0.5, 0.5, 0.71));
}

TEST(Collides, IgnoresUnknownCellsAndTheOutside) {
  EXPECT_FALSE(drawn_map({"?.?"}).collides(1.5, 0.5, 3));
  EXPECT_FALSE(room.collides(-50, 80, 1));
  EXPECT_FALSE(room.collides(nan, 1, 1));
}

TEST(IsClear, TellsWhetherASquareTouchesAWall) {
  const auto sut = drawn_map({"....", "....", "#..."});
  EXPECT_TRUE(sut.is_clear(3.5, 0.5, 2));
  EXPECT_FALSE(sut.is_clear(3.5, 0.5, 3));
  EXPECT_FALSE(sut.is_clear(2.5, 2.5, 2));  // although it is 2.1 m away
}

TEST(IsClear, IsTrueOutsideAndForNan) {
  const auto sut = drawn_map({"#"});
  EXPECT_TRUE(sut.is_clear(-50, 80, 1));
  EXPECT_TRUE(sut.is_clear(nan, 0.5, 1));
  EXPECT_TRUE(sut.is_clear(0.5, nan, 1));
}

TEST(IsClear, IsTrueOnlyWhereNoDiscWithinReachCollides) {
  const auto sut = drawn_map({"..#....", ".......", "#......", "......#", "...#..."});
  int clear = 0;
  for (double x = -1; x < 8; x += 0.23) {
    for (double y = -1; y < 6; y += 0.29) {
      if (!sut.is_clear(x, y, 0.9)) continue;
      ++clear;
      for (double bearing = 0; bearing < 6.3; bearing += 0.1) {
        EXPECT_FALSE(sut.collides(x + 0.6 * std::cos(bearing), y + 0.6 * std::sin(bearing), 0.3));
      }
    }
  }
  EXPECT_GT(clear, 50);
}

TEST(Collides, AgreesWithEveryCellLookedAt) {
  const auto sut = drawn_map({"..#....", ".......", "#......", "......#", "...#..."});
  for (double x = -1; x < 8; x += 0.37) {
    for (double y = -1; y < 6; y += 0.41) {
      bool touches = false;
      for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 7; ++column) {
          if (sut.at(CellIndex{column, row}) != Cell::occupied) continue;
          const double dx = std::max({column - x, 0.0, x - column - 1});
          const double dy = std::max({row - y, 0.0, y - row - 1});
          touches = touches || std::hypot(dx, dy) <= 0.9;
        }
      }
      EXPECT_EQ(sut.collides(x, y, 0.9), touches) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace tocsin::navigation
