// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/distance_map.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::localisation {

/// What a scan says of a pose.
struct Evidence {
  double explained = 0;       ///< share of its beams that end at walls [range 0,1]
  double through = 0;         ///< share that end behind walls
  double log_likelihood = 0;  ///< mean of the beams
};

/// A beam that ends at a wall speaks for a pose, one that ends early (a box, a person) a little
/// against it, one that went through a wall much.
class BeamModel {
 public:
  static constexpr std::size_t asked_beams = 45;  ///< of a scan, at most

  /// Both must outlive it.
  BeamModel(const navigation::OccupancyMap& map, const DistanceMap& distances)
      : map_(map), distances_(distances) {}

  [[nodiscard]] Evidence evidence_of(const laser::Scan& scan, const geometry::Pose& pose) const;
  /// Share of hits that lie at walls [range 0,1].
  [[nodiscard]] double explained(const laser::Points& hits, const geometry::Pose& pose) const;

 private:
  /// Whether a wall lies less than `until_m` away.
  [[nodiscard]] bool meets_wall(const geometry::Point& from, double bearing_rad,
                                double until_m) const;
  const navigation::OccupancyMap& map_;
  const DistanceMap& distances_;
};

}  // namespace tocsin::localisation
