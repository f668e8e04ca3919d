// SPDX-License-Identifier: Apache-2.0
#include "navigator/reconnection.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "navigation/occupancy_map.hpp"
#include "vehicle.hpp"

namespace tocsin {
namespace {

using geometry::Point;
using navigation::CostMap;
using navigation::LinkRisk;

/// 20 m x 4 m; a square metre has the chance that `of` tells.
template <class Of>
LinkRisk risk_of(Of of) {
  const Grid grid{20, 4, 1, {0, 0}};
  std::vector<std::int8_t> percent;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      percent.push_back(static_cast<std::int8_t>(of(grid.centre({column, row}))));
    }
  }
  return {grid, percent};
}

class ReconnectionTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::optional<Point> place(const LinkRisk& risk, const Point& from) {
    return sut_.place(costs_, risk, from, goal_, 0.5);
  }
  /// Stands there until another place is due.
  void wait_in_vain() {
    while (!sut_.on_arrival(now_)) now_ += seconds(1);
  }

  const CostMap costs_{OccupancyMap({200, 40, 0.1, {0, 0}}, std::vector<Cell>(8000, Cell::free)),
                       navigation::InflationParams{}};
  const Point goal_{18, 2};
  Reconnection sut_{Reconnection::Params{}};
  Time now_ = t0;
};

TEST_F(ReconnectionTest, ChoosesThePlaceOnTheWayToTheGoalAndNotTheTrack) {
  const auto risk = risk_of([](const Point& p) { return p.x_m > 5 && p.x_m < 12 ? 98 : 1; });
  const auto at = place(risk, {7.5, 2});
  ASSERT_TRUE(at);
  EXPECT_GT(at->x_m, 12) << "4.5 m ahead, not 2.5 m back";
}

TEST_F(ReconnectionTest, TurnsBackWhereNothingAheadIsHeard) {
  const auto risk = risk_of([](const Point& p) { return p.x_m > 5 ? 98 : 1; });
  const auto at = place(risk, {9, 2});
  ASSERT_TRUE(at);
  EXPECT_LT(at->x_m, 5);
  EXPECT_GT(at->x_m, 4);
}

TEST_F(ReconnectionTest, StaysWithAPlaceUntilItHasWaitedThere) {
  const auto risk = risk_of([](const Point& p) { return p.x_m > 5 && p.x_m < 12 ? 98 : 1; });
  const auto first = place(risk, {7.5, 2});
  const auto same = place(risk, {9, 2});
  EXPECT_EQ(first->x_m, same->x_m);
  EXPECT_FALSE(sut_.on_arrival(now_));
  EXPECT_FALSE(sut_.on_arrival(now_ + seconds(4.9)));
  EXPECT_TRUE(sut_.on_arrival(now_ + seconds(5)));
  const auto next = place(risk, *first);
  ASSERT_TRUE(next);
  EXPECT_GE(distance(*next, *first), 2);
}

TEST_F(ReconnectionTest, GivesUpAfterItsMetres) {
  const auto risk = risk_of([](const Point&) { return 1; });
  Point at{10, 2};
  double driven_m = 0;
  for (int i = 0; i < 100; ++i) {
    const auto next = place(risk, at);
    if (!next) break;
    driven_m += distance(at, *next);
    at = *next;
    wait_in_vain();
  }
  EXPECT_FALSE(place(risk, at));
  EXPECT_GT(driven_m, 5);
  EXPECT_LE(driven_m, 30);
  sut_.end();
  EXPECT_TRUE(place(risk, at)) << "another loss";
}

TEST_F(ReconnectionTest, FindsNothingWhereTheLinkIsNowhere) {
  const auto risk = risk_of([](const Point&) { return 90; });
  EXPECT_FALSE(place(risk, {10, 2}));
  EXPECT_TRUE(sut_.is_on());
}

TEST_F(ReconnectionTest, AWallIsNoPlace) {
  std::vector<Cell> cells(8000, Cell::free);
  for (std::size_t row = 0; row < 40; ++row) cells[row * 200 + 50] = Cell::occupied;
  const CostMap walled(OccupancyMap({200, 40, 0.1, {0, 0}}, cells), navigation::InflationParams{});
  const auto risk = risk_of([](const Point& p) { return p.x_m < 4 ? 1 : 90; });
  EXPECT_FALSE(sut_.place(walled, risk, {9, 2}, goal_, 0.5));
}

}  // namespace
}  // namespace tocsin
