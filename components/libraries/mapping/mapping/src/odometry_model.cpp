// SPDX-License-Identifier: Apache-2.0
#include "mapping/odometry_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tocsin::mapping {
namespace {

using geometry::Pose;

constexpr double forgetting = 0.995;        // a step
constexpr double largest_turn_error = 0.1;  // [rad/m, rad/rad] more is no wheel's fault

double length_of(const Pose& step) { return std::hypot(step.x_m, step.y_m); }

}  // namespace

Pose OdometryModel::corrected(const Pose& step) const {
  const Eigen::Vector2d cause(length_of(step), step.heading_rad);
  const double turn_rad = cause.dot(turn_error_);
  // The way bends evenly: half of the turn is there in the middle of it.
  const Pose turned = geometry::compose({0, 0, turn_rad / 2}, step);
  return {turned.x_m, turned.y_m, geometry::wrap_angle(step.heading_rad + turn_rad)};
}

void OdometryModel::learn(const Pose& step, const Pose& found) {
  const Eigen::Vector2d cause(length_of(step), step.heading_rad);
  const double error_rad = geometry::wrap_angle(found.heading_rad - step.heading_rad);
  normal_ = forgetting * normal_ + (1 - forgetting) * hold * Eigen::Matrix2d::Identity() +
            cause * cause.transpose();
  right_ = forgetting * right_ + cause * error_rad;
  turn_error_ =
      (normal_.inverse() * right_).cwiseMax(-largest_turn_error).cwiseMin(largest_turn_error);
}

SearchWindow OdometryModel::window(const Pose& step) {
  const double length_m = length_of(step);
  return {std::min(0.15 + 0.35 * length_m, 0.8),
          std::min(0.2 + 0.2 * length_m + 0.3 * std::abs(step.heading_rad), 0.9)};
}

GuessTrust OdometryModel::trust(const Pose& step) {
  const SearchWindow reach = window(step);
  return {reach.distance_m / 3, reach.turn_rad / 3};
}

Eigen::Matrix3d OdometryModel::information(const Pose& step) {
  const GuessTrust usual = trust(step);
  const double along = 1 / (usual.distance_m * usual.distance_m);
  return Eigen::Vector3d(along, along, 1 / (usual.turn_rad * usual.turn_rad)).asDiagonal();
}

}  // namespace tocsin::mapping
