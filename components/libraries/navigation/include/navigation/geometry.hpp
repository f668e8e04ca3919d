// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::navigation {

/// A place in the plane [m].
struct Point2 {
  double x = 0;
  double y = 0;
};

/// A place [m] and a heading [rad], counter-clockwise from the x axis.
struct Pose2 {
  double x = 0;
  double y = 0;
  double yaw = 0;
};

/// A velocity of the base: forward [m/s], turning to the left [rad/s].
struct Velocity {
  double v_mps = 0;
  double w_radps = 0;
};

/// Corners of a polyline, the start first.
using Path = std::vector<Point2>;

[[nodiscard]] inline Point2 position(const Pose2& pose) { return {pose.x, pose.y}; }

[[nodiscard]] inline bool is_finite(const Point2& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}
[[nodiscard]] inline bool is_finite(const Pose2& p) {
  return is_finite(position(p)) && std::isfinite(p.yaw);
}

[[nodiscard]] inline double distance(const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);  // no map is so large that std::hypot were worth its price
}

/// Direction of `to` seen from `from` [rad] [range -pi,pi].
[[nodiscard]] inline double bearing(const Point2& from, const Point2& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

/// The point that lies the share `t` of the way from `a` to `b`.
[[nodiscard]] inline Point2 between(const Point2& a, const Point2& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The same angle within [-pi, pi].
[[nodiscard]] inline double wrap_angle(double angle_rad) {
  return std::abs(angle_rad) <= pi ? angle_rad : std::remainder(angle_rad, 2 * pi);
}

/// A unit quaternion (or any multiple of one), as messages carry it.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

/// Heading of a rotation, its roll and pitch ignored [rad] [range -pi,pi].
[[nodiscard]] inline double yaw_of(const Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

[[nodiscard]] inline Quaternion quaternion_from_yaw(double yaw_rad) {
  return {0, 0, std::sin(yaw_rad / 2), std::cos(yaw_rad / 2)};
}

/// `b`, given in the frame of `a`, in the frame that `a` is given in.
[[nodiscard]] inline Pose2 compose(const Pose2& a, const Pose2& b) {
  const double c = std::cos(a.yaw);
  const double s = std::sin(a.yaw);
  return {a.x + c * b.x - s * b.y, a.y + s * b.x + c * b.y, wrap_angle(a.yaw + b.yaw)};
}

}  // namespace tocsin::navigation
