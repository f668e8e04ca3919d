// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/distance_map.hpp"
#include "localisation/map_match.hpp"

namespace tocsin::localisation {

/// How far the vehicle came from scan to scan: by the wheels, unless what stands around says that
/// they have slipped. Scans are matched with one that is at most half a metre old, map or no map,
/// so that boxes serve like walls. Where nothing but a smooth wall is seen, the wheels decide.
///
/// Pure.
class ScanMotion {
 public:
  struct Step {
    geometry::Pose step;
    std::optional<Eigen::Matrix3d> covariance;  ///< of it, where the scans decide
    double seen_before = 1;  ///< share of the hits that lie where something was [range 0,1]
  };

  /// A scan, and the step of the odometry since the last one.
  Step on_scan(const laser::Points& hits, const geometry::Pose& odometry);
  /// The next scan cannot be compared.
  void begin_anew() { key_.reset(); }

 private:
  [[nodiscard]] bool is_hidden(const laser::Points& hits) const;
  void begin(const laser::Points& hits);

  std::optional<DistanceMap> key_;  ///< of the scan that the others are matched with; its frame:
  Belief by_scans_;
  geometry::Pose by_wheels_;
  geometry::Pose told_;
  double usual_hits_ = 0;
  bool is_slipping_ = false;   ///< by the last scan
  bool was_slipping_ = false;  ///< at the end of the scan before that the others were matched with
  double way_ = 0;             ///< of the wheels; 1 m or 1 rad are 1
};

}  // namespace tocsin::localisation
