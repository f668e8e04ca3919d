// SPDX-License-Identifier: Apache-2.0
#include "navigation/tile_map.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin::navigation {
namespace {

constexpr std::size_t cells = std::size_t{TileMap::side} * TileMap::side;
using Put = TileMap::Put;

TEST(TileMap, GrowsToAllSidesAndKeepsEachCellWhereItIs) {
  TileMap sut(0.05);
  EXPECT_EQ(sut.grid().size(), 0U);
  TileMap::Tile tile(cells, Cell::unknown);
  tile[0] = Cell::occupied;
  EXPECT_EQ(sut.put({0, 0}, tile), Put::changed);
  EXPECT_EQ(sut.put({0, 0}, tile), Put::same);
  tile[0] = Cell::free;
  EXPECT_EQ(sut.put({-2, 1}, tile), Put::changed);
  EXPECT_EQ(sut.put({1, -1}, tile), Put::changed);
  const OccupancyMap map = sut.map();
  EXPECT_EQ(map.grid().width, 4 * TileMap::side);
  EXPECT_EQ(map.grid().height, 3 * TileMap::side);
  EXPECT_EQ(map.at(geometry::Point{0.01, 0.01}), Cell::occupied);
  EXPECT_EQ(map.at(geometry::Point{-6.39, 3.21}), Cell::free);
  EXPECT_EQ(map.at(geometry::Point{3.21, -3.19}), Cell::free);
  EXPECT_EQ(map.at(geometry::Point{-1, 0.01}), Cell::unknown) << "no tile is there";
  EXPECT_EQ(sut.corner_of({0, 0}).column, 2 * TileMap::side);
  EXPECT_EQ(sut.corner_of({0, 0}).row, TileMap::side);
}

TEST(TileMap, RefusesATileThatWouldMakeItTooLarge) {
  TileMap sut(0.05);
  const TileMap::Tile tile(cells, Cell::free);
  ASSERT_EQ(sut.put({0, 0}, tile), Put::changed);
  constexpr int end = std::numeric_limits<int>::max();
  for (const TileMap::Index far : {TileMap::Index{80, 80}, {end, 0}, {0, -end - 1}, {end, end}}) {
    EXPECT_EQ(sut.put(far, tile), Put::too_large);
  }
  EXPECT_EQ(sut.tiles().size(), 1U);
  EXPECT_EQ(sut.grid().size(), cells);
}

TEST(TileMap, ItsTilesFitIntoAPacketAndBack) {
  TileMap::Tile tile;
  for (std::size_t i = 0; i < cells; ++i) tile.push_back(static_cast<Cell>(i % 3));
  auto bytes = packed(tile);
  EXPECT_EQ(bytes.size(), 1024U);
  EXPECT_EQ(unpacked_tile(bytes), tile);
  bytes[5] = 0x0c;
  EXPECT_FALSE(unpacked_tile(bytes)) << "3 is no cell";
  bytes.pop_back();
  EXPECT_FALSE(unpacked_tile(bytes));
  EXPECT_FALSE(unpacked_tile({}));
}

}  // namespace
}  // namespace tocsin::navigation
