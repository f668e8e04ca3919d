// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "coverage/floor.hpp"
#include "navigation/cost_map.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::coverage {

struct CoverageParams {
  double width_m = 0.3;
  double overlap_m = 0.04;
  double enough = 0.97;
  navigation::InflationParams inflation;
  template <class Visitor>
  void visit(Visitor& v) {
    v("width_m", width_m, {0.05, 5}, "[m] of the tool, round, in the middle of the robot");
    v("overlap_m", overlap_m, {0, 4}, "[m] of neighbouring swaths, at least");
    v("enough", enough, {0.01, 1},
      "[1] share of the reachable floor; more is not worth a longer way");
    inflation.visit(v);
  }
};

/// A pose of the drive, and the swath that it belongs to.
struct Stop {
  geometry::Pose pose;
  std::size_t swath = 0;
};

/// A drive that covers a floor, and how well.
struct CoveragePlan {
  std::vector<Stop> stops;  ///< in order; headings along the swaths
  geometry::Path path;      ///< from the start on, as Planner drives from stop to stop
  Mask floor;               ///< that can be reached, 1 for each cell
  Mask left_out;            ///< of it
  std::size_t cells = 0;
  std::size_t swaths = 0;
  double floor_m2 = 0;
  double share = 0;            ///< of the reachable floor that the path covers [range 0,1]
  double length_m = 0;         ///< of the path
  double length_to_least = 0;  ///< length x width / area: 1 covers each place once
};

/// Plans it: cells, swaths, their order, the ways between (Planner). Throws ConfigError naming the
/// thing, its value and what is allowed, also of the parameters.
/// Of some plans the shortest that covers enough is returned, or one that nearly does. Takes
/// seconds for the floor of a large building. Pure; any thread.
[[nodiscard]] CoveragePlan plan_coverage(const navigation::OccupancyMap& map,
                                         const CoverageParams& params, const Area& area);

}  // namespace tocsin::coverage
