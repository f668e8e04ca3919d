// SPDX-License-Identifier: Apache-2.0
#include "mapping/map_painter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tocsin::mapping {

using navigation::Cell;
using navigation::TileMap;

bool MapPainter::has_moved(const GlobalMapper& mapper) const {
  constexpr double seen_m = 4;  // walls so far away move with the heading
  const double half_m = tiles_.resolution_m() / 2;
  for (std::size_t i = 0; i < painted_.size(); ++i) {
    const geometry::Pose step = relative(painted_[i], mapper.poses()[i]);
    if (std::hypot(step.x_m, step.y_m) + seen_m * std::abs(step.heading_rad) > half_m) return true;
  }
  return false;
}

void MapPainter::paint(const GlobalMapper& mapper, bool may_begin_anew) {
  const std::size_t before = painted_.size();
  if (may_begin_anew && has_moved(mapper)) {
    grid_ = OccupancyGrid(tiles_.resolution_m());
    painted_.clear();
    is_changed_ = true;
  }
  is_changed_ = is_changed_ || before < mapper.nodes().size();
  for (std::size_t i = painted_.size(); i < mapper.nodes().size(); ++i) {
    painted_.push_back(mapper.poses()[i]);
    grid_.insert(mapper.nodes()[i].scan.unpacked(), painted_.back());
  }
}

TileMap::Tile MapPainter::tile_at(TileMap::Index index) const {
  // Both count in cells from the origin of the frame.
  const double r = tiles_.resolution_m();
  const navigation::CellIndex corner{
      index.column * TileMap::side - static_cast<int>(std::lround(grid_.grid().origin.x_m / r)),
      index.row * TileMap::side - static_cast<int>(std::lround(grid_.grid().origin.y_m / r))};
  TileMap::Tile tile;
  tile.reserve(std::size_t{TileMap::side} * TileMap::side);
  for (int row = 0; row < TileMap::side; ++row) {
    for (int column = 0; column < TileMap::side; ++column) {
      tile.push_back(grid_.at_cell({corner.column + column, corner.row + row}));
    }
  }
  return tile;
}

/// Those of the grid, and those that are there already.
std::set<TileMap::Index> MapPainter::touched() const {
  std::set<TileMap::Index> indices;
  for (const auto& [index, tile] : tiles_.tiles()) indices.insert(index);
  const navigation::Grid& grid = grid_.grid();
  const double cell_m = tiles_.resolution_m();
  const auto tile_of = [&](double m) {
    return static_cast<int>(std::floor(m / (TileMap::side * cell_m)));
  };
  const TileMap::Index low{tile_of(grid.origin.x_m), tile_of(grid.origin.y_m)};
  const TileMap::Index high{tile_of(grid.origin.x_m + grid.width * cell_m),
                            tile_of(grid.origin.y_m + grid.height * cell_m)};
  for (int row = low.row; row <= high.row; ++row) {
    for (int column = low.column; column <= high.column; ++column) indices.insert({column, row});
  }
  return indices;
}

std::vector<MapPainter::Change> MapPainter::take_changes() {
  std::vector<Change> changes;
  if (!std::exchange(is_changed_, false)) return changes;
  for (const TileMap::Index index : touched()) {
    TileMap::Tile tile = tile_at(index);
    const bool is_empty =
        std::all_of(tile.begin(), tile.end(), [](Cell cell) { return cell == Cell::unknown; });
    if (is_empty && tiles_.tiles().count(index) == 0) continue;
    if (tiles_.put(index, tile) != TileMap::Put::changed) continue;
    changes.push_back({index, std::move(tile)});
  }
  return changes;
}

}  // namespace tocsin::mapping
