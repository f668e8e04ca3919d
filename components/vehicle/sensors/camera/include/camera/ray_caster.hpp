// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/wall.hpp"

namespace tocsin::camera {

/// A line of sight on the floor plan. A point on it is start + depth * direction, and its distance
/// from the picture's plane is `depth` when the direction's part along the view is 1.
struct Ray {
  double x_m = 0;
  double y_m = 0;
  double dx = 1;
  double dy = 0;
};

/// The ray through a point of the picture `sideways` to the right of its middle, in focal lengths.
[[nodiscard]] Ray ray_through(const geometry::Pose& view, double sideways);

/// A surface that a ray meets.
struct Hit {
  double depth_m = 0;
  double along_m = 0;  ///< from the first end of the wall: what part of it is seen
  double facing = 1;   ///< [0, 1] 1 when looked at squarely, 0 when from the side
  bool is_furniture = false;
};

/// What the ray meets up to the first wall, farthest first: that wall, if there is one, then the
/// furniture before it. Nothing is nearer than 5 cm. Replaces the content of `hits`.
void cast(const Ray& ray, const std::vector<geometry::Wall>& walls, std::vector<Hit>& hits);

/// A number for each ray of a fan.
using Fan = std::array<double, 8>;

/// Inverse depth [1/m] of the nearest wall that is no furniture along the ray through each of the
/// points `sideways`, at most that of 5 cm; 0 where there is none. What `cast` tells of them, much
/// cheaper.
[[nodiscard]] Fan inverse_depths_per_m(const geometry::Pose& view, const Fan& sideways,
                                       const std::vector<geometry::Wall>& walls);

}  // namespace tocsin::camera
