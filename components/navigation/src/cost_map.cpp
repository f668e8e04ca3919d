// SPDX-License-Identifier: Apache-2.0
#include "navigation/cost_map.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::navigation {
namespace {

/// A cell of the disc around a wall cell, with the cost that the wall gives to it.
struct DiscCell {
  int column;
  int row;
  std::uint16_t cost;
};

std::uint16_t cost_at(double distance_m, const InflationParams& params) {
  const double blocked_m = params.robot_radius_m + params.margin_m;
  if (distance_m <= blocked_m) return 0;
  if (distance_m >= params.soft_radius_m) return CostMap::plain;
  const double share = (params.soft_radius_m - distance_m) / (params.soft_radius_m - blocked_m);
  return static_cast<std::uint16_t>(
      std::lround(CostMap::plain * (1 + std::min(params.soft_weight, 50.0) * share * share)));
}

std::vector<DiscCell> disc_of(double resolution_m, const InflationParams& params) {
  const double reach_m = std::max(params.robot_radius_m + params.margin_m, params.soft_radius_m);
  const int reach = static_cast<int>(std::ceil(reach_m / resolution_m));
  std::vector<DiscCell> disc;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const double distance_m = std::hypot(column, row) * resolution_m;
      if (distance_m <= reach_m) disc.push_back({column, row, cost_at(distance_m, params)});
    }
  }
  return disc;
}

/// Cells in the middle of a wall add nothing to what the wall's rim inflates.
bool is_rim(const OccupancyMap& map, CellIndex c) {
  const auto differs = [&](int columns, int rows) {
    const CellIndex next{c.column + columns, c.row + rows};
    return map.grid().contains(next) && map.at(next) != Cell::occupied;
  };
  return differs(1, 0) || differs(-1, 0) || differs(0, 1) || differs(0, -1);
}

/// The occupied cells that have a neighbour that is not.
std::vector<CellIndex> rim_of(const OccupancyMap& map) {
  std::vector<CellIndex> rim;
  for (int row = 0; row < map.grid().height; ++row) {
    for (int column = 0; column < map.grid().width; ++column) {
      const CellIndex c{column, row};
      if (map.at(c) == Cell::occupied && is_rim(map, c)) rim.push_back(c);
    }
  }
  return rim;
}

bool is_outermost(const Grid& grid, CellIndex c) {
  return c.column == 0 || c.row == 0 || c.column == grid.width - 1 || c.row == grid.height - 1;
}

}  // namespace

CostMap::CostMap(const OccupancyMap& map, const InflationParams& params)
    : grid_(map.grid()), costs_(grid_.size(), 0) {
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      const CellIndex c{column, row};
      if (map.at(c) == Cell::free && !is_outermost(grid_, c)) costs_[grid_.offset(c)] = plain;
    }
  }
  const auto disc = disc_of(grid_.resolution_m, params);
  for (const CellIndex wall : rim_of(map)) {
    for (const DiscCell& d : disc) raise({wall.column + d.column, wall.row + d.row}, d.cost);
  }
}

void CostMap::raise(CellIndex c, std::uint16_t cost) {
  if (!grid_.contains(c)) return;
  std::uint16_t& old = costs_[grid_.offset(c)];
  old = cost == 0 || old == 0 ? std::uint16_t{0} : std::max(old, cost);
}

bool CostMap::blocked(const Point2& p) const {
  const auto cell = grid_.cell_of(p);
  return !cell || blocked(*cell);
}

}  // namespace tocsin::navigation
