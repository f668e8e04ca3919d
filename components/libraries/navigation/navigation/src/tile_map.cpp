// SPDX-License-Identifier: Apache-2.0
#include "navigation/tile_map.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <utility>

namespace tocsin::navigation {
namespace {

constexpr std::int64_t largest_grid = 25'000'000;  // as load_map takes
constexpr int most_index = 1'000'000;              // to all sides: 3,200 km
constexpr std::size_t cells_a_tile = std::size_t{TileMap::side} * TileMap::side;
constexpr std::size_t cells_a_byte = 4;
constexpr std::array<Cell, 3> cell_of_code{Cell::unknown, Cell::free, Cell::occupied};

unsigned code_of(Cell cell) {
  return static_cast<unsigned>(std::find(cell_of_code.begin(), cell_of_code.end(), cell) -
                               cell_of_code.begin());
}

}  // namespace

/// Of size 0 when that would be too large.
Grid TileMap::grid_with(Index index) const {
  if (std::max(std::abs(std::int64_t{index.column}), std::abs(std::int64_t{index.row})) >
      most_index) {
    return {};
  }
  Index low = index;
  Index high = index;
  if (!tiles_.empty()) {
    low = {std::min(low.column, low_.column), std::min(low.row, low_.row)};
    high = {std::max(high.column, low_.column + grid_.width / side - 1),
            std::max(high.row, low_.row + grid_.height / side - 1)};
  }
  const std::int64_t width = (std::int64_t{high.column} - low.column + 1) * side;
  const std::int64_t height = (std::int64_t{high.row} - low.row + 1) * side;
  if (width > largest_grid || height > largest_grid || width * height > largest_grid) return {};
  const double tile_m = side * resolution_m_;
  return {static_cast<int>(width),
          static_cast<int>(height),
          resolution_m_,
          {low.column * tile_m, low.row * tile_m}};
}

TileMap::Put TileMap::put(Index index, Tile tile) {
  assert(tile.size() == cells_a_tile);
  const auto known = tiles_.find(index);
  if (known != tiles_.end()) {
    if (known->second == tile) return Put::same;
    known->second = std::move(tile);
    return Put::changed;
  }
  const Grid grid = grid_with(index);
  if (grid.width == 0) return Put::too_large;
  low_ = tiles_.empty() ? index
                        : Index{std::min(low_.column, index.column), std::min(low_.row, index.row)};
  grid_ = grid;
  tiles_.emplace(index, std::move(tile));
  return Put::changed;
}

CellIndex TileMap::corner_of(Index index) const {
  return {(index.column - low_.column) * side, (index.row - low_.row) * side};
}

OccupancyMap TileMap::map() const {
  assert(!tiles_.empty());
  std::vector<Cell> cells(grid_.size(), Cell::unknown);
  for (const auto& [index, tile] : tiles_) {
    const CellIndex corner = corner_of(index);
    for (int row = 0; row < side; ++row) {
      std::copy_n(tile.begin() + std::ptrdiff_t{row} * side, side,
                  cells.begin() +
                      static_cast<std::ptrdiff_t>(grid_.offset({corner.column, corner.row + row})));
    }
  }
  return {grid_, std::move(cells)};
}

std::vector<std::uint8_t> packed(const TileMap::Tile& tile) {
  std::vector<std::uint8_t> bytes(tile.size() / cells_a_byte, 0);
  for (std::size_t i = 0; i < tile.size(); ++i) {
    auto& byte = bytes[i / cells_a_byte];
    byte = static_cast<std::uint8_t>(byte | code_of(tile[i]) << (2 * (i % cells_a_byte)));
  }
  return bytes;
}

std::optional<TileMap::Tile> unpacked_tile(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() != cells_a_tile / cells_a_byte) return std::nullopt;
  TileMap::Tile tile;
  tile.reserve(cells_a_tile);
  for (std::size_t i = 0; i < cells_a_tile; ++i) {
    const std::size_t code = bytes[i / cells_a_byte] >> (2 * (i % cells_a_byte)) & 3U;
    if (code >= cell_of_code.size()) return std::nullopt;
    tile.push_back(cell_of_code[code]);
  }
  return tile;
}

}  // namespace tocsin::navigation
