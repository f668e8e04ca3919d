// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/distance_map.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::localisation {

/// Poses from which a scan may have been seen: every free cell of a lattice of 0.2 m, in 60
/// headings, is tried with 40 hits. The best of each neighbourhood (0.5 m, 20 degrees), best first,
/// at most `most`. Takes 1 us for each 5 cm2 of free floor.
[[nodiscard]] std::vector<geometry::Pose> search_everywhere(const navigation::OccupancyMap& map,
                                                            const DistanceMap& distances,
                                                            const laser::Points& hits,
                                                            std::size_t most);

}  // namespace tocsin::localisation
