// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "navigation/distance_field.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::exploration {

/// Cells side by side where the robot can be and beside which something is not known
/// (Yamauchi 1997).
struct Frontier {
  std::vector<navigation::CellIndex> cells;
  geometry::Point middle;  ///< mean of the cells' middles; may lie anywhere [m]
  double length_m = 0;     ///< cells x side of a cell
};

/// All that `ways` leads to, in the order of the map's rows. A floor that the robot could reach and
/// that is not known has one of these on each way to it.
[[nodiscard]] std::vector<Frontier> find_frontiers(const navigation::OccupancyMap& map,
                                                   const navigation::DistanceField& ways);

}  // namespace tocsin::exploration
