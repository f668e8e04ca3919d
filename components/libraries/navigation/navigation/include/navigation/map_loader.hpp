// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "geometry/pose.hpp"
#include "navigation/cost_map.hpp"
#include "navigation/occupancy_map.hpp"
#include "navigation/pgm.hpp"

namespace tocsin::navigation {

/// How the greys of a map image are read (ROS map_server, mode trinary).
/// The share of black is 1 - pixel / max, or pixel / max when `negate` is set.
struct MapScale {
  double resolution_m = 0.05;
  geometry::Point origin;  // lower left corner of the image, map frame
  bool negate = false;
  double occupied_thresh = 0.65;  // more black is occupied
  double free_thresh = 0.196;     // less black is free, the rest is unknown
};

[[nodiscard]] OccupancyMap map_from_image(const GrayImage& image, const MapScale& scale);

/// Reads a map in the format of ROS's map_server: a YAML file beside a PGM image.
/// Throws ConfigError naming file and reason: unreadable, unknown or missing key, value out of
/// range, rotated origin, other mode than trinary, bad image.
[[nodiscard]] OccupancyMap load_map(const std::string& yaml_path);
/// What it costs to cross the cells of that map; computed once for the same file and parameters.
[[nodiscard]] std::shared_ptr<const CostMap> load_costs(const std::string& yaml_path,
                                                        const InflationParams& params);

}  // namespace tocsin::navigation
