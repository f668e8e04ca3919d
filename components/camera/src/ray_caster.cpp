// SPDX-License-Identifier: Apache-2.0
#include "camera/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tocsin::camera {
namespace {

constexpr double nearest_m = 0.05;

/// Solves start + depth * d = first end + share * e.
std::optional<Hit> meet(const Ray& ray, const Wall& wall) {
  const double ex = wall.x2_m - wall.x1_m, ey = wall.y2_m - wall.y1_m;
  const double cross = ray.dx * ey - ray.dy * ex;
  const double length_m = std::sqrt(ex * ex + ey * ey);
  if (length_m == 0 || std::abs(cross) < 1e-12 * length_m) return std::nullopt;
  const double fx = wall.x1_m - ray.x_m, fy = wall.y1_m - ray.y_m;
  const double depth_m = (fx * ey - fy * ex) / cross;
  const double share = (fx * ray.dy - fy * ray.dx) / cross;
  if (depth_m < nearest_m || share < 0 || share > 1) return std::nullopt;
  const double facing = std::abs(cross) / length_m / std::sqrt(ray.dx * ray.dx + ray.dy * ray.dy);
  return Hit{depth_m, share * length_m, facing, wall.is_furniture};
}

}  // namespace

Ray ray_through(const View& view, double sideways) {
  const double c = std::cos(view.yaw_rad), s = std::sin(view.yaw_rad);
  return {view.x_m, view.y_m, c + sideways * s, s - sideways * c};
}

void cast(const Ray& ray, const std::vector<Wall>& walls, std::vector<Hit>& hits) {
  hits.clear();
  for (const Wall& wall : walls) {
    if (const auto hit = meet(ray, wall)) hits.push_back(*hit);
  }
  std::sort(hits.begin(), hits.end(),
            [](const Hit& a, const Hit& b) { return a.depth_m < b.depth_m; });
  const auto wall =
      std::find_if(hits.begin(), hits.end(), [](const Hit& hit) { return !hit.is_furniture; });
  if (wall != hits.end()) hits.erase(wall + 1, hits.end());
  std::reverse(hits.begin(), hits.end());
}

std::optional<double> depth_to_wall_m(const Ray& ray, const std::vector<Wall>& walls) {
  std::optional<double> depth_m;
  for (const Wall& wall : walls) {
    if (wall.is_furniture) continue;
    const double ex = wall.x2_m - wall.x1_m, ey = wall.y2_m - wall.y1_m;
    const double cross = ray.dx * ey - ray.dy * ex;
    if (cross * cross <= 1e-24 * (ex * ex + ey * ey)) continue;  // parallel, or a point
    const double fx = wall.x1_m - ray.x_m, fy = wall.y1_m - ray.y_m;
    const double share = (fx * ray.dy - fy * ray.dx) / cross;
    if (share < 0 || share > 1) continue;
    const double here_m = (fx * ey - fy * ex) / cross;
    if (here_m >= nearest_m && (!depth_m || here_m < *depth_m)) depth_m = here_m;
  }
  return depth_m;
}

}  // namespace tocsin::camera
