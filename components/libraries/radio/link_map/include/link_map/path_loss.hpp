// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::link_map {

/// Usual in buildings (n 2 to 4.5 is measured).
inline constexpr double usual_exponent = 3;

/// Signal by distance: K - 10 n log10(max(d, 1 m)).
struct PathLoss {
  geometry::Point access_point;
  double at_1_m_dbm = -40;           ///< K
  double exponent = usual_exponent;  ///< n [range 1,6]

  [[nodiscard]] double signal_dbm(const geometry::Point& at) const;
  /// 1, and -10 log10 of the distance: what K and n are multiplied with.
  [[nodiscard]] Eigen::Vector2d basis(const geometry::Point& at) const;
};

/// Where an access point may be: a lattice of 2.5 m up to 15 m around the places, coarser where
/// these are far apart.
[[nodiscard]] std::vector<geometry::Point> access_points_around(
    const std::vector<geometry::Point>& places);

/// The path loss that fits signals at places best (least squares), of those whose access point is
/// one of `access_points_around`. n is held near 3 (deviation 1), so that a way that leads along a
/// wave front teaches no nonsense.
[[nodiscard]] PathLoss fit_path_loss(const std::vector<geometry::Point>& places,
                                     const Eigen::VectorXd& signals_dbm);

}  // namespace tocsin::link_map
