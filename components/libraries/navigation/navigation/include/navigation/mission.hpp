// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/pose.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {

inline constexpr std::size_t most_waypoints = 4095;  ///< of a mission

/// A pose to drive to.
struct Waypoint : geometry::Pose {
  static constexpr double most_send_s = 3600;
  /// [s] [range 0,most_send_s] that a vehicle stands there at most until its stored samples have
  /// crossed the link.
  double send_s = 0;
};

/// Places to visit one after the other.
struct Mission {
  std::string name;
  std::string frame = "map";
  std::vector<Waypoint> waypoints;
  std::string file;  // where it was read, for error texts
};

/// Reads a mission: our YAML (`name`, `frame`, `waypoints: [{x, y, yaw, send_s}, ...]`) or, from a
/// file named *.jsonl, the JSON lines of the thesis (one waypoint a line: posx, posy and the
/// quaternion orx, ory, orz, orw; latency and ts are ignored). Throws ConfigError naming file,
/// waypoint or line, and reason. A mission has 1 to most_waypoints. The same file is read once,
/// while it does not change.
[[nodiscard]] Mission load_mission(const std::string& path);

/// Throws ConfigError naming waypoint, position and file when a robot of this radius cannot stand
/// on a waypoint: in a wall, nearer to one than `radius_m`, or on an unknown cell.
void require_free(const Mission& mission, const OccupancyMap& map, double radius_m);

}  // namespace tocsin::navigation
