// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "mapping/scan_matcher.hpp"

namespace tocsin::mapping {

/// What wheels get wrong. Learns the systematic part of the turn (unequal wheels: so much a metre;
/// a wrong track width: so much a radian) from what the matcher finds, and says how far to search.
class OdometryModel {
 public:
  /// A measured step of the odometry, corrected by what is learned.
  [[nodiscard]] geometry::Pose corrected(const geometry::Pose& step) const;
  /// `found` is what the matcher made of the measured step.
  void learn(const geometry::Pose& step, const geometry::Pose& found);

  /// Errors of a step are within it in all but extreme cases (a wheel that slips).
  [[nodiscard]] static SearchWindow window(const geometry::Pose& step);
  /// Usual errors of a step.
  [[nodiscard]] static GuessTrust trust(const geometry::Pose& step);
  /// Inverse covariance of a step in its own frame.
  [[nodiscard]] static Eigen::Matrix3d information(const geometry::Pose& step);

 private:
  /// Holds both parameters near 0 until about so many [m^2, rad^2] have been seen.
  static constexpr double hold = 10.0;
  // Least squares with forgetting.
  Eigen::Matrix2d normal_ = Eigen::Matrix2d::Identity() * hold;
  Eigen::Vector2d right_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d turn_error_ = Eigen::Vector2d::Zero();  // [rad/m, rad/rad]
};

}  // namespace tocsin::mapping
