// SPDX-License-Identifier: Apache-2.0
#include "navigation/link_risk.hpp"

#include <gtest/gtest.h>

#include "navigation/cost_map.hpp"

namespace tocsin::navigation {
namespace {

/// 2 m wide, 1 m high, from (-1, 0): nothing, a tenth, all, unknown.
const LinkRisk four({4, 1, 0.5, {-1, 0}}, {0, 10, 100, -1});

TEST(LinkRisk, IsThatOfItsCellAndOutsideThatOfTheRim) {
  EXPECT_DOUBLE_EQ(four.at({-0.9, 0.2}), 0);
  EXPECT_DOUBLE_EQ(four.at({-0.2, 0.4}), 0.1);
  EXPECT_DOUBLE_EQ(four.at({0.2, 0.4}), 1);
  EXPECT_DOUBLE_EQ(four.at({0.9, 0.1}), 0.5) << "not known";
  EXPECT_DOUBLE_EQ(four.at({-100, 50}), 0);
  EXPECT_DOUBLE_EQ(four.at({1e9, -1e9}), 0.5);
}

TEST(LinkRisk, CountsTheMetresWithoutLink) {
  EXPECT_NEAR(four.silent_m({{-1, 0.2}, {1, 0.2}}), 0.5 * (0 + 0.1 + 1 + 0.5), 1e-9);
  EXPECT_NEAR(four.silent_m({{0, 0.2}, {0.5, 0.2}, {0, 0.2}}), 1, 1e-9);
  EXPECT_DOUBLE_EQ(four.silent_m({{0.2, 0.2}}), 0);
  EXPECT_DOUBLE_EQ(four.silent_m({}), 0);
}

TEST(LinkRisk, OfAFinerGridIsThatOfEachOfItsCells) {
  const Grid fine{11, 5, 0.25, {-1.5, -0.1}};
  const auto cells = four.on(fine);
  ASSERT_EQ(cells.size(), fine.size());
  for (int row = 0; row < fine.height; ++row) {
    for (int column = 0; column < fine.width; ++column) {
      EXPECT_FLOAT_EQ(cells[fine.offset({column, row})],
                      static_cast<float>(four.at(fine.centre({column, row}))));
    }
  }
}

TEST(LinkRisk, MakesCellsDearerAndOpensNone) {
  const OccupancyMap map({8, 8, 0.25, {-1, 0}}, std::vector<Cell>(64, Cell::free));
  const CostMap plain(map, {0.05, 0, 0, 0});
  const CostMap dear(plain, four.on(map.grid()), 4);
  const auto cost = [](const CostMap& costs, const geometry::Point& p) {
    return costs.cost(costs.grid().offset(*costs.grid().cell_of(p)));
  };
  EXPECT_EQ(cost(plain, {0.1, 0.3}), CostMap::plain);
  EXPECT_EQ(cost(dear, {0.1, 0.3}), 5 * CostMap::plain);
  EXPECT_EQ(cost(dear, {-0.6, 0.3}), CostMap::plain);
  EXPECT_TRUE(dear.blocked(CellIndex{0, 3})) << "the map's rim";
  EXPECT_EQ(cost(CostMap(plain, four.on(map.grid()), 1000), {0.1, 0.3}), CostMap::dearest);
}

}  // namespace
}  // namespace tocsin::navigation
