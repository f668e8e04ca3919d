// SPDX-License-Identifier: Apache-2.0
#include "navigation/link_way.hpp"

#include <gtest/gtest.h>

#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {
namespace {

/// A hall of 20 m x 10 m, through whose middle a straight line crosses a dead zone.
class LinkWayTest : public ::testing::Test {
 protected:
  static constexpr double cell_m = 0.25;
  [[nodiscard]] static LinkRisk dead_zone(double from_x_m, double to_x_m, double to_y_m) {
    const Grid grid{40, 20, 0.5, {0, 0}};
    std::vector<std::int8_t> percent;
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const auto p = grid.centre({column, row});
        percent.push_back(p.x_m > from_x_m && p.x_m < to_x_m && p.y_m < to_y_m ? 95 : 1);
      }
    }
    return {grid, percent};
  }
  [[nodiscard]] geometry::Path shortest(const geometry::Point& from) {
    return *planner_.plan(from, goal_);
  }

  [[nodiscard]] WayChoice choose(LinkWayChooser& chooser, const geometry::Path& shortest,
                                 const LinkRisk& risk) const {
    return chooser.choose(shortest, *costs_, risk, risk.on(costs_->grid()));
  }

  const std::shared_ptr<const CostMap> costs_ = std::make_shared<const CostMap>(
      OccupancyMap({80, 40, cell_m, {0, 0}}, std::vector<Cell>(80U * 40U, Cell::free)),
      InflationParams{0.18, 0.07, 0.6, 3});
  Planner planner_{costs_};
  const geometry::Point start_{2, 4};
  const geometry::Point goal_{18, 4};
  LinkWayChooser sut_{0.15};
};

TEST_F(LinkWayTest, GoesRoundADeadZoneWhereThatIsNotTooFar) {
  const auto choice = choose(sut_, shortest(start_), dead_zone(8, 12, 6));
  EXPECT_NEAR(choice.shortest.length_m, 16, 0.2);
  EXPECT_GT(choice.shortest.silent_m, 3.5);
  EXPECT_LT(choice.way.silent_m, 0.5);
  EXPECT_LT(choice.way.length_m, 16.2 * 1.15);
  EXPECT_FALSE(choice.shortest.path.empty());
}

TEST_F(LinkWayTest, DrivesThroughWhereTheWayRoundIsTooFar) {
  const auto choice = choose(sut_, shortest(start_), dead_zone(4, 16, 9.2));
  EXPECT_NEAR(choice.way.length_m, 16, 0.2);
  EXPECT_GT(choice.way.silent_m, 10);
  EXPECT_TRUE(choice.shortest.path.empty()) << "it is the way";
  EXPECT_DOUBLE_EQ(choice.shortest.silent_m, choice.way.silent_m);
}

TEST_F(LinkWayTest, TakesTheShortestWayWhereTheLinkIsGood) {
  const auto choice = choose(sut_, shortest(start_), dead_zone(0, 0, 0));
  EXPECT_NEAR(choice.way.length_m, 16, 0.2);
  EXPECT_TRUE(choice.shortest.path.empty());
}

TEST_F(LinkWayTest, DoesNotGiveUpHalfOfADetour) {
  const LinkRisk risk = dead_zone(8, 12, 6);
  geometry::Point at = start_;
  for (int i = 0; i < 20; ++i) {
    const auto choice = choose(sut_, shortest(at), risk);
    EXPECT_LT(choice.way.silent_m, 0.8) << "from " << at.x_m << ", " << at.y_m;
    const auto& path = choice.way.path;
    at = between(path[0], path[1], std::min(1.0, 0.5 / distance(path[0], path[1])));
  }
  EXPECT_GT(at.x_m, 10);
}

TEST_F(LinkWayTest, AnotherGoalHasItsOwnAllowance) {
  const LinkRisk risk = dead_zone(8, 12, 6);
  (void)choose(sut_, shortest({12.5, 4}), risk);  // no detour is needed
  sut_.begin();
  EXPECT_LT(choose(sut_, shortest(start_), risk).way.silent_m, 0.5);
}

TEST_F(LinkWayTest, WhatOneGoalLeavesTheNextMayUse) {
  const LinkRisk risk = dead_zone(6, 14, 8);
  EXPECT_GT(choose(sut_, shortest(start_), risk).way.silent_m, 6) << "too far for 15 %";
  sut_.begin();
  (void)choose(sut_, *planner_.plan({18, 9}, {2, 9}), risk);  // needs no detour
  int round = 0;
  for (; round < 10; ++round) {
    sut_.begin();
    if (choose(sut_, shortest(start_), risk).way.silent_m > 6) break;
  }
  EXPECT_GE(round, 1);
  EXPECT_LT(round, 5) << "it is used up";
}

TEST_F(LinkWayTest, WithoutAnAllowanceItIsTheShortest) {
  LinkWayChooser none(0);
  const auto choice = choose(none, shortest(start_), dead_zone(8, 12, 6));
  EXPECT_NEAR(choice.way.length_m, 16, 0.2);
  EXPECT_GT(choice.way.silent_m, 3.5);
}

}  // namespace
}  // namespace tocsin::navigation
