// SPDX-License-Identifier: Apache-2.0
#include "map_ports/live_map.hpp"

#include <gtest/gtest.h>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

using navigation::Cell;
using Cells = std::vector<std::int8_t>;

const navigation::Grid grid{3, 2, 0.5, {-1, 2}};

TEST(LiveMap, ReadsOccupanciesAsMapServerDoes) {
  LiveMap sut;
  EXPECT_FALSE(sut.map());
  EXPECT_EQ(sut.replace(grid, {0, 19, 20, 64, 65, 100}), "");
  const std::vector<Cell> expected{Cell::free,    Cell::free,     Cell::unknown,
                                   Cell::unknown, Cell::occupied, Cell::occupied};
  EXPECT_EQ(sut.map()->cells(), expected);
  EXPECT_EQ(sut.map()->grid().origin.y_m, 2);
  EXPECT_EQ(sut.replace({2, 1, 0.5, {0, 0}}, {-1, 127}), "");
  EXPECT_EQ(sut.map()->cells(), (std::vector<Cell>{Cell::unknown, Cell::unknown}));
}

TEST(LiveMap, TakesTiles) {
  LiveMap sut;
  ASSERT_EQ(sut.replace(grid, Cells(6, -1)), "");
  EXPECT_EQ(sut.update({1, 0, 2, 2}, {0, 100, 100, 0}), "");
  const std::vector<Cell> expected{Cell::unknown, Cell::free,     Cell::occupied,
                                   Cell::unknown, Cell::occupied, Cell::free};
  EXPECT_EQ(sut.map()->cells(), expected);
  EXPECT_EQ(sut.update({3, 2, 0, 0}, {}), "") << "an empty one changes nothing";
}

TEST(LiveMap, RefusesWhatIsNoMapAndKeepsTheOneBefore) {
  LiveMap sut;
  ASSERT_EQ(sut.replace(grid, Cells(6, 0)), "");
  const Cells one(1, 100);
  for (const navigation::Grid& bad : {navigation::Grid{0, 1, 0.5, {0, 0}},
                                      {-1, 1, 0.5, {0, 0}},
                                      {2147483647, 2147483647, 0.5, {0, 0}},
                                      {1, 1, 0, {0, 0}},
                                      {1, 1, nan, {0, 0}},
                                      {1, 1, infinity, {0, 0}},
                                      {1, 1, 0.5, {nan, 0}},
                                      {2, 1, 0.5, {0, 0}}}) {
    EXPECT_NE(sut.replace(bad, one), "");
  }
  EXPECT_EQ(sut.map()->cells(), std::vector<Cell>(6, Cell::free));
}

TEST(LiveMap, RefusesTilesThatDoNotFit) {
  LiveMap sut;
  EXPECT_NE(sut.update({0, 0, 1, 1}, {0}), "") << "of no map";
  ASSERT_EQ(sut.replace(grid, Cells(6, 0)), "");
  for (const LiveMap::Tile& bad : {LiveMap::Tile{-1, 0, 1, 1},
                                   {3, 0, 1, 1},
                                   {0, 2, 1, 1},
                                   {2, 1, 4294967295, 1},
                                   {0, 0, 2, 1},
                                   {0, -2147483648, 1, 1}}) {
    EXPECT_NE(sut.update(bad, {100}), "");
  }
  EXPECT_EQ(sut.map()->cells(), std::vector<Cell>(6, Cell::free));
}

}  // namespace
}  // namespace tocsin
