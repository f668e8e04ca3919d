// SPDX-License-Identifier: Apache-2.0
#include "map_ports/live_map.hpp"

#include <cmath>

namespace tocsin {
namespace {

using navigation::Cell;

constexpr std::int64_t most_cells = 25'000'000;  // as load_map takes
constexpr int occupied_percent = 65;
constexpr int free_percent = 19;

Cell cell_of(std::int8_t percent) {
  if (percent >= occupied_percent && percent <= 100) return Cell::occupied;
  return percent >= 0 && percent <= free_percent ? Cell::free : Cell::unknown;
}

std::string counts(std::size_t has, std::int64_t needs) {
  return "it has " + std::to_string(has) + " cells where its size needs " + std::to_string(needs);
}

}  // namespace

std::string LiveMap::replace(const navigation::Grid& grid, const std::vector<std::int8_t>& cells) {
  if (grid.width < 1 || grid.height < 1 || std::int64_t{grid.width} * grid.height > most_cells) {
    return "its size of " + std::to_string(grid.width) + " x " + std::to_string(grid.height) +
           " cells is outside [1, 25 million]";
  }
  if (!(grid.resolution_m >= 1e-3 && grid.resolution_m <= 10)) {
    return "its resolution of " + std::to_string(grid.resolution_m) + " m is outside [0.001, 10]";
  }
  if (!is_finite(grid.origin)) return "its origin is not finite";
  if (cells.size() != grid.size()) {
    return counts(cells.size(), static_cast<std::int64_t>(grid.size()));
  }
  grid_ = grid;
  cells_.clear();
  cells_.reserve(cells.size());
  for (const std::int8_t percent : cells) cells_.push_back(cell_of(percent));
  return "";
}

std::string LiveMap::update(const Tile& tile, const std::vector<std::int8_t>& cells) {
  if (cells_.empty()) return "there is no map yet that it is a part of";
  const bool is_inside = tile.x >= 0 && tile.y >= 0 && tile.width >= 0 && tile.height >= 0 &&
                         tile.width <= grid_.width - tile.x && tile.height <= grid_.height - tile.y;
  if (!is_inside) return "it is not within the map";
  if (cells.size() != static_cast<std::size_t>(tile.width * tile.height)) {
    return counts(cells.size(), tile.width * tile.height);
  }
  auto from = cells.begin();
  for (std::int64_t row = 0; row < tile.height; ++row) {
    const auto first = grid_.offset({static_cast<int>(tile.x), static_cast<int>(tile.y + row)});
    for (std::int64_t column = 0; column < tile.width; ++column) {
      cells_[first + static_cast<std::size_t>(column)] = cell_of(*from++);
    }
  }
  return "";
}

std::optional<navigation::OccupancyMap> LiveMap::map() const {
  if (cells_.empty()) return std::nullopt;
  return navigation::OccupancyMap{grid_, cells_};
}

}  // namespace tocsin
