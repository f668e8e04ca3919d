// SPDX-License-Identifier: Apache-2.0
#include "navigation/cost_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tocsin::navigation {
namespace {

constexpr std::uint16_t nothing = 1;  // less than any cost

std::uint16_t cost_at(double distance_m, const InflationParams& params) {
  const double blocked_m = params.robot_radius_m + params.margin_m;
  if (distance_m <= blocked_m) return 0;
  if (distance_m >= params.soft_radius_m) return CostMap::plain;
  const double share = (params.soft_radius_m - distance_m) / (params.soft_radius_m - blocked_m);
  return static_cast<std::uint16_t>(
      std::lround(CostMap::plain * (1 + std::min(params.soft_weight, 50.0) * share * share)));
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
  const Grid& grid = map.grid();
  for (int row = 0; row < grid.height; ++row) {
    const Cell* const cells = &map.cells()[grid.offset({0, row})];
    for (int column = 0; column < grid.width; ++column) {
      if (cells[column] != Cell::occupied) continue;
      if (is_rim(map, {column, row})) rim.push_back({column, row});
    }
  }
  return rim;
}

}  // namespace

/// A row of the disc around a wall cell, with the costs that the wall gives to its cells; an odd
/// number of them, the middle one in the wall's column.
struct CostMap::DiscRow {
  int row;
  std::vector<std::uint16_t> costs;
};

std::vector<CostMap::DiscRow> CostMap::disc_of(double resolution_m, const InflationParams& params) {
  const double reach_m = std::max(params.robot_radius_m + params.margin_m, params.soft_radius_m);
  const int reach = static_cast<int>(std::ceil(reach_m / resolution_m));
  std::vector<DiscRow> disc;
  for (int row = -reach; row <= reach; ++row) {
    DiscRow cells{row, {}};
    for (int column = -reach; column <= reach; ++column) {
      const double distance_m = std::hypot(column, row) * resolution_m;
      cells.costs.push_back(distance_m <= reach_m ? cost_at(distance_m, params) : nothing);
    }
    disc.push_back(std::move(cells));
  }
  return disc;
}

CostMap::CostMap(const OccupancyMap& map, const InflationParams& params)
    : grid_(map.grid()), costs_(grid_.size(), 0) {
  for (int row = 1; row + 1 < grid_.height; ++row) {  // the outermost cells stay blocked
    const Cell* const cells = &map.cells()[grid_.offset({0, row})];
    std::uint16_t* const costs = &costs_[grid_.offset({0, row})];
    for (int column = 1; column + 1 < grid_.width; ++column) {
      costs[column] = cells[column] == Cell::free ? plain : std::uint16_t{0};
    }
  }
  const auto disc = disc_of(grid_.resolution_m, params);
  for (const CellIndex wall : rim_of(map)) {
    for (const DiscRow& row : disc) raise(wall, row);
  }
}

CostMap::CostMap(const CostMap& base, const std::vector<CellIndex>& obstacles,
                 const InflationParams& params)
    : CostMap(base) {
  const auto disc = disc_of(grid_.resolution_m, params);
  for (const CellIndex obstacle : obstacles) {
    for (const DiscRow& row : disc) raise(obstacle, row);
  }
}

CostMap::CostMap(const CostMap& base, const std::vector<float>& shares, double weight)
    : CostMap(base) {
  assert(shares.size() == costs_.size());
  const auto factor = static_cast<float>(weight);
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    const float dear = static_cast<float>(costs_[i]) * (1 + factor * shares[i]);
    costs_[i] = static_cast<std::uint16_t>(std::lround(std::min(dear, float{dearest})));
  }
}

void CostMap::raise(CellIndex wall, const DiscRow& disc) {
  const int row = wall.row + disc.row;
  if (row < 0 || row >= grid_.height) return;
  const int half = static_cast<int>(disc.costs.size() / 2);
  const int first = std::max(0, wall.column - half);
  const int last = std::min(grid_.width - 1, wall.column + half);
  std::uint16_t* const costs = &costs_[grid_.offset({first, row})];
  const std::uint16_t* const asked =
      &disc.costs[static_cast<std::size_t>(first - (wall.column - half))];
  const auto rank = [](std::uint16_t cost) { return static_cast<std::uint16_t>(cost - 1U); };
  for (int i = 0; i <= last - first; ++i) {  // 0 - 1 is the dearest rank
    costs[i] = rank(asked[i]) > rank(costs[i]) ? asked[i] : costs[i];
  }
}

bool CostMap::blocked(const geometry::Point& p) const {
  const auto cell = grid_.cell_of(p);
  return !cell || blocked(*cell);
}

std::optional<CellIndex> CostMap::nearest_free(const geometry::Point& p, double reach_m) const {
  const auto middle = grid_.cell_of(p);
  if (!middle || !blocked(*middle)) return middle;
  const int reach = static_cast<int>(reach_m / grid_.resolution_m);
  std::optional<CellIndex> best;
  double best_m = reach_m;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const CellIndex cell{middle->column + column, middle->row + row};
      const double away_m = distance(p, grid_.centre(cell));
      if (blocked(cell) || away_m >= best_m) continue;
      best = cell;
      best_m = away_m;
    }
  }
  return best;
}

}  // namespace tocsin::navigation
