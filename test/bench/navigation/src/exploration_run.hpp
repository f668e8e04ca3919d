// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "random_world.hpp"

namespace tocsin::bench {

/// How a drive through an unknown building went.
struct ExplorationRun {
  bool has_ended = false;  ///< by itself, within 1,000 goals
  double share_known = 0;  ///< of the cells where the robot could be [range 0,1]
  double path_m = 0;
  int goals = 0;
  int bumps = 0;                   ///< drives that touched something
  std::size_t listed = 0;          ///< places given up
  std::vector<double> choices_ms;  ///< time of each choice
};

/// Drives with an RPLIDAR A1 at known poses; looks every 0.1 m, chooses anew every 0.5 m.
/// `failing`: share of the goals that fail whatever they are.
[[nodiscard]] ExplorationRun explore(const World& world, double failing, std::uint64_t seed);

}  // namespace tocsin::bench
