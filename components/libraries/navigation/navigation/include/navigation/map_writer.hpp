// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {

/// A map as a PGM image (P5) in the greys of ROS's map_saver: free 254, occupied 0, unknown 205.
[[nodiscard]] std::string pgm_of(const OccupancyMap& map);

/// Writes `name`.yaml and `name`.pgm, which load_map and ROS's map_server open. Each is replaced in
/// one step, the image first. Throws ConfigError when one cannot be written, or when the map has
/// more cells than load_map takes.
void write_map(const OccupancyMap& map, const std::string& name);

}  // namespace tocsin::navigation
