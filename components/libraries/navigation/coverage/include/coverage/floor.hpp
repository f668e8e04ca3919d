// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "coverage/mask.hpp"
#include "navigation/cost_map.hpp"

namespace tocsin::coverage {

/// What is asked for.
struct Area {
  geometry::Point start;                 ///< where the robot is, map frame
  std::vector<geometry::Point> polygon;  ///< empty: all that can be reached
};

/// What there is to cover.
struct Floor {
  Mask centres;  ///< where the middle of the robot can be
  Mask floor;    ///< what the tool can reach from there: the "reachable floor"
};

/// The free floor that a tool of `width_m` reaches. Throws ConfigError naming the thing, its value
/// and what is allowed: a start that is not finite, outside of the map or walled in; a polygon that
/// is none, is outside of the map, or has nothing in it that can be reached.
[[nodiscard]] Floor reachable_floor(const navigation::OccupancyMap& map,
                                    const navigation::CostMap& costs, const Area& area,
                                    double width_m);

/// What a tool of `width_m` reaches from `centres`, of the cells of `within`.
[[nodiscard]] Mask reached_from(const Mask& centres, const Mask& within, double width_m);

}  // namespace tocsin::coverage
