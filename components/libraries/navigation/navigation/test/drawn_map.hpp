// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.hpp"
#include "navigation/occupancy_map.hpp"
#include "navigation/planner.hpp"

namespace tocsin::navigation {

/// A map drawn in text, the top row first: '#' occupied, '.' free, '?' unknown; origin (0, 0).
inline OccupancyMap drawn_map(const std::vector<std::string>& rows, double resolution_m = 1.0) {
  const Grid grid{
      static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), resolution_m, {0, 0}};
  std::vector<Cell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      cells.push_back(c == '#' ? Cell::occupied : c == '.' ? Cell::free : Cell::unknown);
    }
  }
  return {grid, cells};
}

/// A plan of a planner that made none before.
inline std::optional<geometry::Path> plan(const CostMap& map, const geometry::Point& start,
                                          const geometry::Point& goal) {
  return Planner(std::make_shared<const CostMap>(map)).plan(start, goal);
}

/// A free rectangle of this many cells of 0.05 m.
inline OccupancyMap open_floor(int width, int height) {
  const Grid grid{width, height, 0.05, {0, 0}};
  return {grid, std::vector<Cell>(grid.size(), Cell::free)};
}

}  // namespace tocsin::navigation
