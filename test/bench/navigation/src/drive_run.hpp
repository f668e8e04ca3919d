// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/pose.hpp"
#include "laser_model/scene.hpp"
#include "navigation/occupancy_map.hpp"
#include "navigator/navigator.hpp"
#include "people.hpp"

namespace tocsin::bench {

/// One drive of a simulated Kobuki with an RPLIDAR A1 and a collision brake, from a pose to a
/// place.
struct DriveTask {
  laser::Scene scene;
  People people;                 ///< who walk in it
  navigation::OccupancyMap map;  ///< what the navigator knows before it starts
  geometry::Pose start;
  geometry::Point goal;
  double most_s = 100;
  std::uint64_t seed = 1;
};

enum class DriveEnd {
  arrived,
  collided,
  struck,  ///< somebody walked into it while it stood
  timed_out
};

struct DriveResult {
  DriveEnd end = DriveEnd::timed_out;
  double time_s = 0;
  double way_m = 0;
  double scan_us = 0;    ///< of the navigator, median
  double update_us = 0;  ///< median
  double brake_us = 0;   ///< of the brake for a scan and a velocity, medians
  double plan_us = 0;    ///< of the longest update, which plans
  geometry::Pose last;
  const char* reason = "";  ///< of the navigator's last standing
};

/// Poses are the true ones; commands reach the wheels after the base's dead time.
[[nodiscard]] DriveResult drive(DriveTask task, const Navigator::Params& params);

}  // namespace tocsin::bench
