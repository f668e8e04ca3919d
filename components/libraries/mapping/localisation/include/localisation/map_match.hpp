// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/distance_map.hpp"

namespace tocsin::localisation {

/// A pose on a map and how sure it is: covariance of x [m], y [m], heading [rad].
struct Belief {
  geometry::Pose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// The pose at which `hits` (frame of the vehicle) lie on the walls, near what was believed: Gauss
/// and Newton on the distances to the nearest wall, with Cauchy's weights of scale 0.1 m; hits
/// farther than 0.5 m from a wall are of something else. Along a direction that no hit tells of,
/// such as a corridor's axis, the belief stays.
///
/// The hits of a scan are no independent witnesses: together they count as `witnesses`, each with
/// a deviation of 0.05 m.
[[nodiscard]] Belief match(const DistanceMap& map, const laser::Points& hits, const Belief& before,
                           double witnesses = 12);

}  // namespace tocsin::localisation
