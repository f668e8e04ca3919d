// SPDX-License-Identifier: Apache-2.0
#include "navigation/cost_percent.hpp"

#include <gmock/gmock.h>

namespace tocsin::navigation {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;

constexpr double cell_m = 0.1;
constexpr int side = 41;
const Grid grid{side, side, cell_m, {-2.05, -2.05}};

/// A free floor with a wall at its left side and an unknown lower row.
OccupancyMap room() {
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int row = 0; row < side; ++row) cells[grid.offset({2, row})] = Cell::occupied;
  for (int column = 0; column < side; ++column) cells[grid.offset({column, 0})] = Cell::unknown;
  return {grid, std::move(cells)};
}

class CostPercentTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::int8_t> percents(const CellWindow& window) const {
    const std::vector<CellIndex> box{{30, 30}};
    return cost_percents(CostMap(CostMap(floor_, {}), box, {}), floor_, box, window);
  }
  [[nodiscard]] std::int8_t percent(CellIndex cell) const {
    return percents({{0, 0}, side, side})[grid.offset(cell)];
  }
  const OccupancyMap floor_ = room();
};

TEST_F(CostPercentTest, AreThoseOfNav2) {
  EXPECT_EQ(percent({20, 20}), 0);
  EXPECT_EQ(percent({2, 20}), 100);
  EXPECT_EQ(percent({4, 20}), 99);
  EXPECT_THAT(percent({6, 20}), AllOf(Ge(1), Le(98)));
  EXPECT_EQ(percent({20, 0}), -1);
  EXPECT_EQ(percent({30, 30}), 100) << "what is seen";
  EXPECT_EQ(percent({31, 30}), 99);
}

TEST_F(CostPercentTest, OfAWindowAreThoseOfTheWholeThere) {
  const CellWindow window = window_around(grid, {1, 1}, 1);
  const auto part = percents(window);
  ASSERT_EQ(part.size(), part_of(grid, window).size());
  for (int row = 0; row < window.height; ++row) {
    for (int column = 0; column < window.width; ++column) {
      const CellIndex there{window.low.column + column, window.low.row + row};
      EXPECT_EQ(part[part_of(grid, window).offset({column, row})], percent(there));
    }
  }
}

TEST(CellWindowTest, IsCutAtTheRim) {
  const CellWindow window = window_around(grid, {-2, 0}, 1);
  EXPECT_EQ(window.low.column, 0);
  EXPECT_EQ(window.width, 6);
  EXPECT_EQ(window.height, 11);
  EXPECT_DOUBLE_EQ(part_of(grid, window).origin.y_m, grid.origin.y_m + window.low.row * cell_m);
}

TEST(CellWindowTest, BesideTheGridHasNoCell) {
  EXPECT_EQ(window_around(grid, {50, 0}, 1).width, 0);
  EXPECT_EQ(part_of(grid, window_around(grid, {50, 0}, 1)).size(), 0U);
}

TEST_F(CostPercentTest, OfNothingAreNone) { EXPECT_THAT(percents({}), Each(0)); }

}  // namespace
}  // namespace tocsin::navigation
