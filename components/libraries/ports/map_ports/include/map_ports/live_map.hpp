// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "navigation/occupancy_map.hpp"

namespace tocsin {

/// A map that is published whole once and then in tiles where it has changed.
///
/// Cells are occupancies [%], -1 unknown. As map_server reads its images: from 65 on occupied, up
/// to 19 free, else unknown. Pure.
class LiveMap {
 public:
  struct Tile {
    std::int64_t x = 0;  ///< column of its lower left cell
    std::int64_t y = 0;  ///< row
    std::int64_t width = 0;
    std::int64_t height = 0;
  };

  /// A whole map, its rows not turned. Returns why it is refused, the one before stays; empty: it
  /// is taken.
  [[nodiscard]] std::string replace(const navigation::Grid& grid,
                                    const std::vector<std::int8_t>& cells);
  /// A part of it, likewise.
  [[nodiscard]] std::string update(const Tile& tile, const std::vector<std::int8_t>& cells);

  /// Nothing until a whole one was taken.
  [[nodiscard]] std::optional<navigation::OccupancyMap> map() const;

 private:
  navigation::Grid grid_;
  std::vector<navigation::Cell> cells_;
};

}  // namespace tocsin
