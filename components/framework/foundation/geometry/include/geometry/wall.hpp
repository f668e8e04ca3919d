// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/pose.hpp"

namespace tocsin::geometry {

/// Something upright that stands on the floor, seen from above as a straight line. Map frame.
struct Wall {
  double x1_m = 0;
  double y1_m = 0;
  double x2_m = 0;
  double y2_m = 0;
  double loss_db = 0;  ///< of a radio wave that crosses it [range 0,100]

  /// What costs no loss is below the antennas: one can look over it.
  [[nodiscard]] bool is_furniture() const { return loss_db == 0; }
};

/// Twice the signed area of the triangle: positive when `c` lies to the left of the way from `a` to
/// `b`.
[[nodiscard]] inline double side(const Point& a, const Point& b, const Point& c) {
  return (b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m);
}

/// Whether the straight way from `a` to `b` and the wall cross. Touching ends do not count.
[[nodiscard]] inline bool crosses(const Wall& wall, const Point& a, const Point& b) {
  const Point from{wall.x1_m, wall.y1_m};
  const Point to{wall.x2_m, wall.y2_m};
  return side(from, to, a) * side(from, to, b) < 0 && side(a, b, from) * side(a, b, to) < 0;
}

/// The point of the wall that is nearest to `p`.
[[nodiscard]] inline Point nearest_point(const Wall& wall, const Point& p) {
  const Point from{wall.x1_m, wall.y1_m};
  const Point to{wall.x2_m, wall.y2_m};
  return between(from, to, nearest_share(from, to, p));
}

}  // namespace tocsin::geometry
