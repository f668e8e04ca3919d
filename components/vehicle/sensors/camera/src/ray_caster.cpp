// SPDX-License-Identifier: Apache-2.0
#include "camera/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/wall.hpp"

namespace tocsin::camera {
namespace {

constexpr double nearest_m = 0.05;

/// Solves start + depth * d = first end + share * e.
std::optional<Hit> meet(const Ray& ray, const geometry::Wall& wall) {
  const double ex = wall.x2_m - wall.x1_m, ey = wall.y2_m - wall.y1_m;
  const double cross = ray.dx * ey - ray.dy * ex;
  const double length_m = std::sqrt(ex * ex + ey * ey);
  if (length_m == 0 || std::abs(cross) < 1e-12 * length_m) return std::nullopt;
  const double fx = wall.x1_m - ray.x_m, fy = wall.y1_m - ray.y_m;
  const double depth_m = (fx * ey - fy * ex) / cross;
  const double share = (fx * ray.dy - fy * ray.dx) / cross;
  if (depth_m < nearest_m || share < 0 || share > 1) return std::nullopt;
  const double facing = std::abs(cross) / length_m / std::sqrt(ray.dx * ray.dx + ray.dy * ray.dy);
  return Hit{depth_m, share * length_m, facing, wall.is_furniture()};
}

/// A place as seen from the camera.
struct Seen {
  double right_m;
  double depth_m;
};

/// Along a wall the inverse depth is linear in the picture. A wall whose line passes through the
/// camera is seen from the side: it gives an infinity or NaN, neither of which counts.
void bring_nearer(const Seen& a, const Seen& b, const Fan& sideways, Fan& nearest_per_m) {
  const double scale = 1 / (a.right_m * b.depth_m - b.right_m * a.depth_m);
  for (std::size_t i = 0; i < sideways.size(); ++i) {
    const double a_beside_m = a.right_m - sideways[i] * a.depth_m;
    const double b_beside_m = b.right_m - sideways[i] * b.depth_m;
    if (a_beside_m * b_beside_m > 0) continue;  // both ends on the same side of the ray
    const double here_per_m = (a_beside_m - b_beside_m) * scale;
    if (here_per_m > nearest_per_m[i] && here_per_m <= 1 / nearest_m) nearest_per_m[i] = here_per_m;
  }
}

}  // namespace

Ray ray_through(const geometry::Pose& view, double sideways) {
  const double c = std::cos(view.heading_rad), s = std::sin(view.heading_rad);
  return {view.x_m, view.y_m, c + sideways * s, s - sideways * c};
}

void cast(const Ray& ray, const std::vector<geometry::Wall>& walls, std::vector<Hit>& hits) {
  hits.clear();
  for (const geometry::Wall& wall : walls) {
    if (const auto hit = meet(ray, wall)) hits.push_back(*hit);
  }
  std::sort(hits.begin(), hits.end(),
            [](const Hit& a, const Hit& b) { return a.depth_m < b.depth_m; });
  const auto wall =
      std::find_if(hits.begin(), hits.end(), [](const Hit& hit) { return !hit.is_furniture; });
  if (wall != hits.end()) hits.erase(wall + 1, hits.end());
  std::reverse(hits.begin(), hits.end());
}

Fan inverse_depths_per_m(const geometry::Pose& view, const Fan& sideways,
                         const std::vector<geometry::Wall>& walls) {
  const double c = std::cos(view.heading_rad), s = std::sin(view.heading_rad);
  const auto seen = [&](double x_m, double y_m) {
    const double dx = x_m - view.x_m, dy = y_m - view.y_m;
    return Seen{dx * s - dy * c, dx * c + dy * s};
  };
  Fan nearest{};
  for (const geometry::Wall& wall : walls) {
    if (wall.is_furniture()) continue;
    const Seen a = seen(wall.x1_m, wall.y1_m), b = seen(wall.x2_m, wall.y2_m);
    if (a.depth_m > 0 || b.depth_m > 0) bring_nearer(a, b, sideways, nearest);
  }
  return nearest;
}

}  // namespace tocsin::camera
