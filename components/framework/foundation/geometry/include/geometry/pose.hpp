// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::geometry {

/// A place in the plane.
struct Point {
  double x_m = 0;
  double y_m = 0;
};

/// A place and a heading in the plane; the heading counter-clockwise from the x axis.
struct Pose {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
};

/// Corners of a polyline, the start first.
using Path = std::vector<Point>;

[[nodiscard]] inline Point position(const Pose& pose) { return {pose.x_m, pose.y_m}; }

[[nodiscard]] inline bool is_finite(const Point& p) {
  return std::isfinite(p.x_m) && std::isfinite(p.y_m);
}
[[nodiscard]] inline bool is_finite(const Pose& p) {
  return is_finite(position(p)) && std::isfinite(p.heading_rad);
}

/// [m]
[[nodiscard]] inline double distance(const Point& a, const Point& b) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  return std::sqrt(dx * dx + dy * dy);  // no map is so large that std::hypot were worth its price
}

/// Direction of `to` seen from `from` [rad] [range -pi,pi].
[[nodiscard]] inline double bearing(const Point& from, const Point& to) {
  return std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
}

/// The point that lies the share `t` of the way from `a` to `b`.
[[nodiscard]] inline Point between(const Point& a, const Point& b, double t) {
  return {a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)};
}

/// The share of the way from `a` to `b` at which it is nearest to `p` [range 0,1]; 0 where both are
/// the same.
[[nodiscard]] inline double nearest_share(const Point& a, const Point& b, const Point& p) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double square = dx * dx + dy * dy;
  if (square == 0) return 0;
  return std::clamp(((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / square, 0.0, 1.0);
}

/// The same angle within (-pi, pi]; NaN for NaN and infinity.
[[nodiscard]] inline double wrap_angle(double angle_rad) {
  if (angle_rad > -pi && angle_rad <= pi) return angle_rad;
  const double wrapped = std::remainder(angle_rad, 2 * pi);
  return wrapped <= -pi ? wrapped + 2 * pi : wrapped;
}

/// A unit quaternion (or any multiple of one), as messages carry it.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

/// Heading of a rotation, its roll and pitch ignored [rad] [range -pi,pi].
[[nodiscard]] inline double heading_of(const Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

[[nodiscard]] inline Quaternion quaternion_of(double heading_rad) {
  return {0, 0, std::sin(heading_rad / 2), std::cos(heading_rad / 2)};
}

/// `b`, given in the frame of `a`, in the frame that `a` is given in.
[[nodiscard]] inline Pose compose(const Pose& a, const Pose& b) {
  const double c = std::cos(a.heading_rad);
  const double s = std::sin(a.heading_rad);
  return {a.x_m + c * b.x_m - s * b.y_m, a.y_m + s * b.x_m + c * b.y_m,
          wrap_angle(a.heading_rad + b.heading_rad)};
}

/// The pose of the frame that `pose` is given in, in the frame of `pose`.
[[nodiscard]] inline Pose inverse(const Pose& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  return {-c * pose.x_m - s * pose.y_m, s * pose.x_m - c * pose.y_m, wrap_angle(-pose.heading_rad)};
}

/// `to` in the frame of `from`, both given in the same frame.
[[nodiscard]] inline Pose relative(const Pose& from, const Pose& to) {
  return compose(inverse(from), to);
}

}  // namespace tocsin::geometry
