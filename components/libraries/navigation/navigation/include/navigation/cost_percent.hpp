// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "navigation/cost_map.hpp"

namespace tocsin::navigation {

/// A rectangle of a grid's cells, all of them in the grid.
struct CellWindow {
  CellIndex low;
  int width = 0;
  int height = 0;
};

/// What of a square of so many metres around a place lies in the grid; no cell where nothing does.
[[nodiscard]] CellWindow window_around(const Grid& grid, const geometry::Point& middle,
                                       double side_m);

/// The grid that a window is.
[[nodiscard]] Grid part_of(const Grid& grid, const CellWindow& window);

/// Costs as Nav2's costmaps tell them (nav2_costmap_2d, Costmap2DPublisher), row by row: 0 far from
/// everything, 1 to 98 near something, 99 where the robot would touch it, 100 an obstacle, -1
/// unknown. Asserts that costs and floor have the same size.
[[nodiscard]] std::vector<std::int8_t> cost_percents(const CostMap& costs,
                                                     const OccupancyMap& floor,
                                                     const std::vector<CellIndex>& obstacles,
                                                     const CellWindow& window);

}  // namespace tocsin::navigation
