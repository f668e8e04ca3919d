// SPDX-License-Identifier: Apache-2.0
#include "coverage/tour.hpp"

#include <gtest/gtest.h>

#include "floors.hpp"

namespace tocsin::coverage {
namespace {

double way_between(const std::vector<SwathCell>& cells, geometry::Point at) {
  double sum = 0;
  for (const SwathCell& cell : cells) {
    for (const Swath& swath : cell) {
      sum += distance(at, swath.from);
      at = swath.to;
    }
  }
  return sum;
}

TEST(Tour, DrivesACellToAndFroFromTheNearestCorner) {
  const navigation::CostMap costs(room(5, 5, 0, false), {});
  const SwathCell cell{{{-1, 0}, {1, 0}}, {{-1, 0.3}, {1, 0.3}}, {{-1, 0.6}, {1, 0.6}}};
  const auto sut = order_cells({cell}, costs, {1.2, 0.7});
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_NEAR(sut[0][0].from.x_m, 1, 1e-9);
  EXPECT_NEAR(sut[0][0].from.y_m, 0.6, 1e-9);
  EXPECT_NEAR(sut[0][1].from.x_m, -1, 1e-9);
  EXPECT_NEAR(sut[0][2].to.x_m, -1, 1e-9);
  EXPECT_NEAR(way_between(sut, {1, 0.6}), 0.6, 1e-9);
}

TEST(Tour, IsShorterThanTheNearestCellEachTime) {
  // A line of single swaths on both sides of the start: the nearest one each time leads to and fro.
  const navigation::CostMap costs(room(9, 3, 0, false), {});
  std::vector<SwathCell> cells;
  for (const double x : {-0.2, 0.3, -0.8, 1.2, -2.0, 3.8}) cells.push_back({{{x, -0.5}, {x, 0.5}}});
  const auto sut = order_cells(cells, costs, {0, 0});
  EXPECT_EQ(sut.size(), 6U);
  EXPECT_LT(way_between(sut, {0, 0}), 2 + 6.5);
}

TEST(Tour, LeavesOutWhatCannotBeReached) {
  const navigation::CostMap costs(room(3, 3, 0, false), {});
  const auto sut = order_cells({{{{0, 0}, {1, 0}}}, {{{50, 0}, {51, 0}}}}, costs, {0, 0});
  EXPECT_EQ(sut.size(), 1U);
}

}  // namespace
}  // namespace tocsin::coverage
