// SPDX-License-Identifier: Apache-2.0
#include "exploration/frontier.hpp"

#include <cassert>
#include <cstdint>

namespace tocsin::exploration {
namespace {

using navigation::Cell;
using navigation::CellIndex;
using navigation::Grid;

/// Calls `visit` for the eight neighbours that are on the grid.
template <class Visit>
void around(const Grid& grid, CellIndex c, const Visit& visit) {
  for (int i = 0; i < 9; ++i) {
    const CellIndex next{c.column + i % 3 - 1, c.row + i / 3 - 1};
    if (i != 4 && grid.contains(next)) visit(next);
  }
}

bool is_frontier(const navigation::OccupancyMap& map, const navigation::DistanceField& ways,
                 CellIndex c) {
  if (!ways.reaches(map.grid().offset(c))) return false;
  bool sees_unknown = false;
  around(map.grid(), c,
         [&](CellIndex next) { sees_unknown = sees_unknown || map.at(next) == Cell::unknown; });
  return sees_unknown;
}

Frontier take(std::vector<std::uint8_t>& left, const Grid& grid, CellIndex from) {
  Frontier frontier;
  frontier.cells.push_back(from);
  left[grid.offset(from)] = 0;
  for (std::size_t i = 0; i < frontier.cells.size(); ++i) {
    around(grid, frontier.cells[i], [&](CellIndex next) {
      if (left[grid.offset(next)] == 0) return;
      left[grid.offset(next)] = 0;
      frontier.cells.push_back(next);
    });
  }
  const auto count = static_cast<double>(frontier.cells.size());
  for (const CellIndex c : frontier.cells) {
    const auto at = grid.centre(c);
    frontier.middle.x_m += at.x_m / count;
    frontier.middle.y_m += at.y_m / count;
  }
  frontier.length_m = count * grid.resolution_m;
  return frontier;
}

}  // namespace

std::vector<Frontier> find_frontiers(const navigation::OccupancyMap& map,
                                     const navigation::DistanceField& ways) {
  const Grid& grid = map.grid();
  assert(ways.grid().size() == grid.size());
  std::vector<std::uint8_t> left(grid.size(), 0);
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      left[grid.offset({column, row})] = is_frontier(map, ways, {column, row});
    }
  }
  std::vector<Frontier> frontiers;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      if (left[grid.offset({column, row})] == 0) continue;
      frontiers.push_back(take(left, grid, {column, row}));
    }
  }
  return frontiers;
}

}  // namespace tocsin::exploration
