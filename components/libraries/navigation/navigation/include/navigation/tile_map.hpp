// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {

/// A map that grows to all sides, in square tiles. Tile (0, 0) has its lower left corner at the
/// origin of the map's frame, so that tiles of the same map fit together wherever they come from.
///
/// Pure.
class TileMap {
 public:
  static constexpr int side = 64;  ///< cells
  struct Index {
    int column = 0;
    int row = 0;
    bool operator<(const Index& o) const { return row != o.row ? row < o.row : column < o.column; }
    bool operator==(const Index& o) const { return row == o.row && column == o.column; }
  };
  /// Row by row from below, side x side.
  using Tile = std::vector<Cell>;
  enum class Put { changed, same, too_large };

  explicit TileMap(double resolution_m) : resolution_m_(resolution_m) {}

  /// Asserts its size. A tile that would make `grid` larger than load_map takes, 25 million cells,
  /// is refused.
  Put put(Index index, Tile tile);

  [[nodiscard]] double resolution_m() const { return resolution_m_; }
  [[nodiscard]] const std::map<Index, Tile>& tiles() const { return tiles_; }
  /// All of them; of size 0 when there is none.
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// The column and row in `grid` of a tile's lower left cell.
  [[nodiscard]] CellIndex corner_of(Index index) const;
  /// Unknown where there is no tile. Asserts that there is one.
  [[nodiscard]] OccupancyMap map() const;

 private:
  [[nodiscard]] Grid grid_with(Index index) const;
  double resolution_m_;
  std::map<Index, Tile> tiles_;
  Index low_;
  Grid grid_;
};

/// Four cells a byte, the first in its low bits: 0 unknown, 1 free, 2 occupied.
[[nodiscard]] std::vector<std::uint8_t> packed(const TileMap::Tile& tile);
/// Empty when it is not as long as `packed` makes it, or has another code.
[[nodiscard]] std::optional<TileMap::Tile> unpacked_tile(const std::vector<std::uint8_t>& bytes);

}  // namespace tocsin::navigation
