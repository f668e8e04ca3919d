// SPDX-License-Identifier: Apache-2.0
#include "navigation/cost_percent.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tocsin::navigation {
namespace {

constexpr std::int8_t unknown = -1;
constexpr std::int8_t touched = 99;
constexpr std::int8_t obstacle = 100;

std::int8_t percent_of(std::uint16_t cost, Cell floor) {
  if (floor == Cell::unknown) return unknown;
  if (floor == Cell::occupied) return obstacle;
  if (cost == 0) return touched;
  if (cost <= CostMap::plain) return 0;
  const int above = std::min(cost, CostMap::dearest) - CostMap::plain;
  return static_cast<std::int8_t>(1 + 97 * above / (CostMap::dearest - CostMap::plain));
}

}  // namespace

CellWindow window_around(const Grid& grid, const geometry::Point& middle, double side_m) {
  const double from_m = -side_m / 2;
  const auto cell = [&](double at_m, double origin_m) {
    return static_cast<int>(std::floor((at_m - origin_m) / grid.resolution_m));
  };
  const CellIndex low{std::max(0, cell(middle.x_m + from_m, grid.origin.x_m)),
                      std::max(0, cell(middle.y_m + from_m, grid.origin.y_m))};
  const CellIndex high{std::min(grid.width, cell(middle.x_m - from_m, grid.origin.x_m) + 1),
                       std::min(grid.height, cell(middle.y_m - from_m, grid.origin.y_m) + 1)};
  if (high.column <= low.column || high.row <= low.row) return {};
  return {low, high.column - low.column, high.row - low.row};
}

Grid part_of(const Grid& grid, const CellWindow& window) {
  Grid part = grid;
  part.width = window.width;
  part.height = window.height;
  part.origin.x_m += window.low.column * grid.resolution_m;
  part.origin.y_m += window.low.row * grid.resolution_m;
  return part;
}

std::vector<std::int8_t> cost_percents(const CostMap& costs, const OccupancyMap& floor,
                                       const std::vector<CellIndex>& obstacles,
                                       const CellWindow& window) {
  assert(costs.grid().size() == floor.grid().size());
  std::vector<std::int8_t> percents;
  percents.reserve(part_of(floor.grid(), window).size());
  for (int row = window.low.row; row < window.low.row + window.height; ++row) {
    for (int column = window.low.column; column < window.low.column + window.width; ++column) {
      const CellIndex cell{column, row};
      percents.push_back(percent_of(costs.cost(floor.grid().offset(cell)), floor.at(cell)));
    }
  }
  const Grid part = part_of(floor.grid(), window);
  for (const CellIndex& seen : obstacles) {
    const CellIndex cell{seen.column - window.low.column, seen.row - window.low.row};
    if (part.contains(cell)) percents[part.offset(cell)] = obstacle;
  }
  return percents;
}

}  // namespace tocsin::navigation
