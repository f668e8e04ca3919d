// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/pose.hpp"

namespace tocsin::mapping {

/// The pose of the frame that `pose` is given in, in the frame of `pose`.
[[nodiscard]] inline geometry::Pose inverse(const geometry::Pose& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  return {-c * pose.x_m - s * pose.y_m, s * pose.x_m - c * pose.y_m,
          geometry::wrap_angle(-pose.heading_rad)};
}

/// `to` in the frame of `from`, both given in the same frame.
[[nodiscard]] inline geometry::Pose relative(const geometry::Pose& from, const geometry::Pose& to) {
  return geometry::compose(inverse(from), to);
}

}  // namespace tocsin::mapping
