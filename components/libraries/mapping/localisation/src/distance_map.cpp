// SPDX-License-Identifier: Apache-2.0
#include "localisation/distance_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tocsin::localisation {
namespace {

using navigation::Cell;
using navigation::CellIndex;
using navigation::Grid;

/// A row of the disc around an occupied cell, with the distances of its cells; an odd number of
/// them, the middle one in the cell's column.
struct DiscRow {
  int row;
  std::vector<float> distances_m;
};

std::vector<DiscRow> disc_of(double resolution_m) {
  const double most_cells = DistanceMap::most_m / resolution_m;
  const int reach = static_cast<int>(most_cells);
  std::vector<DiscRow> disc;
  for (int row = -reach; row <= reach; ++row) {
    DiscRow cells{row, {}};
    const int half = static_cast<int>(std::sqrt(most_cells * most_cells - double(row) * row));
    for (int column = -half; column <= half; ++column) {
      const double away_m = std::hypot(row, column) * resolution_m;
      cells.distances_m.push_back(static_cast<float>(std::min(away_m, DistanceMap::most_m)));
    }
    disc.push_back(std::move(cells));
  }
  return disc;
}

/// The cells of a row come as near as the middle of the disc is.
void approach(std::vector<float>& distances_m, const Grid& grid, CellIndex middle,
              const DiscRow& disc) {
  const int row = middle.row + disc.row;
  if (row < 0 || row >= grid.height) return;
  const int half = static_cast<int>(disc.distances_m.size() / 2);
  const int first = std::max(0, middle.column - half);
  const int last = std::min(grid.width - 1, middle.column + half);
  float* const cells = &distances_m[grid.offset({first, row})];
  const float* const away =
      &disc.distances_m[static_cast<std::size_t>(first - (middle.column - half))];
  for (int i = 0; i <= last - first; ++i) cells[i] = std::min(cells[i], away[i]);
}

/// Nothing is nearer to the middle of a wall than to its rim.
bool is_rim(const navigation::OccupancyMap& map, CellIndex c) {
  const auto is_open = [&](int columns, int rows) {
    const CellIndex next{c.column + columns, c.row + rows};
    return map.grid().contains(next) && map.at(next) != Cell::occupied;
  };
  return is_open(1, 0) || is_open(-1, 0) || is_open(0, 1) || is_open(0, -1);
}

}  // namespace

DistanceMap::DistanceMap(const navigation::OccupancyMap& map)
    : grid_(map.grid()), distances_m_(grid_.size(), static_cast<float>(most_m)) {
  const auto disc = disc_of(grid_.resolution_m);
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      const CellIndex cell{column, row};
      if (map.at(cell) != Cell::occupied) continue;
      distances_m_[grid_.offset(cell)] = 0;
      if (!is_rim(map, cell)) continue;
      for (const DiscRow& cells : disc) approach(distances_m_, grid_, cell, cells);
    }
  }
}

DistanceMap::Sample DistanceMap::sample(const geometry::Point& p) const {
  const double column = (p.x_m - grid_.origin.x_m) / grid_.resolution_m - 0.5;
  const double row = (p.y_m - grid_.origin.y_m) / grid_.resolution_m - 0.5;
  if (!(column >= 0 && row >= 0 && column < grid_.width - 1 && row < grid_.height - 1)) return {};
  const int c = static_cast<int>(column);
  const int r = static_cast<int>(row);
  const double u = column - c;
  const double v = row - r;
  const std::size_t at = grid_.offset({c, r});
  const std::size_t above = at + static_cast<std::size_t>(grid_.width);
  const double d00 = distances_m_[at], d10 = distances_m_[at + 1];
  const double d01 = distances_m_[above], d11 = distances_m_[above + 1];
  return {(1 - v) * ((1 - u) * d00 + u * d10) + v * ((1 - u) * d01 + u * d11),
          ((1 - v) * (d10 - d00) + v * (d11 - d01)) / grid_.resolution_m,
          ((1 - u) * (d01 - d00) + u * (d11 - d10)) / grid_.resolution_m};
}

double DistanceMap::nearest_m(const geometry::Point& p) const {
  const auto cell = grid_.cell_of(p);
  return cell ? distances_m_[grid_.offset(*cell)] : most_m;
}

}  // namespace tocsin::localisation
