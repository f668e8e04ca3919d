// SPDX-License-Identifier: Apache-2.0
#include "coverage/swaths.hpp"

#include <gtest/gtest.h>

#include "foundation/numbers.hpp"

namespace tocsin::coverage {
namespace {

/// Cells of 0.1 m, the top row first, '.' in the mask.
Mask drawn(const std::vector<std::string>& rows) {
  Mask mask(navigation::Grid{int(rows.front().size()), int(rows.size()), 0.1, {0, 0}});
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      const navigation::CellIndex c{int(column), int(rows.size() - 1 - row)};
      mask.cells[mask.grid.offset(c)] = rows[row][column] == '.';
    }
  }
  return mask;
}

TEST(SwathCells, OfARectangleAreOneCell) {
  const auto sut = swath_cells(drawn({"......", "......", "......"}), {0, 0.1, 0});
  ASSERT_EQ(sut.size(), 1U);
  ASSERT_EQ(sut[0].size(), 3U);
  EXPECT_NEAR(sut[0][0].from.x_m, 0.05, 1e-9);
  EXPECT_NEAR(sut[0][0].to.x_m, 0.55, 1e-9);
  EXPECT_NEAR(sut[0][0].from.y_m, 0.05, 1e-9);
  EXPECT_NEAR(sut[0][2].from.y_m, 0.25, 1e-9);
}

TEST(SwathCells, DivideRoundAnObstacleAndJoinBehindIt) {
  const auto sut = swath_cells(drawn({"......", "..##..", "..##..", "......"}), {0, 0.1, 0});
  ASSERT_EQ(sut.size(), 4U) << "below, left, right, above";
  EXPECT_EQ(swaths_in(sut), 6U);
  EXPECT_EQ(sut[1].size(), 2U);
  EXPECT_EQ(sut[2].size(), 2U);
}

TEST(SwathCells, AcrossRunTheOtherWay) {
  const auto sut = swath_cells(drawn({"......", "......", "......"}), {pi / 2, 0.1, 0});
  EXPECT_EQ(swaths_in(sut), 6U);
}

TEST(FittedPattern, BeginsAndEndsAtTheSidesAndIsNoWiderThanAsked) {
  const Mask mask = drawn(std::vector<std::string>(11, "......"));  // middles 1 m apart
  const Pattern sut = fitted(mask, {0, 0.3, 0}, 0.05);
  EXPECT_NEAR(sut.first_m, 0.05, 1e-9);
  EXPECT_NEAR(sut.spacing_m, 0.9 / 3, 1e-9);
  EXPECT_EQ(swaths_in(swath_cells(mask, sut)), 4U);
  const Pattern narrow = fitted(drawn({"......"}), {0, 0.3, 0}, 0.05);
  EXPECT_EQ(swaths_in(swath_cells(drawn({"......"}), narrow)), 1U);
}

TEST(SwathCells, OfNothingAreNone) { EXPECT_TRUE(swath_cells(drawn({"##"}), {0, 0.1, 0}).empty()); }

}  // namespace
}  // namespace tocsin::coverage
