// SPDX-License-Identifier: Apache-2.0
#include "mapping/scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tocsin::mapping {

Scan make_scan(const std::vector<double>& ranges_m, const Beams& beams, const ScanParams& params) {
  Scan scan;
  scan.laser = geometry::position(beams.laser);
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const double range_m = ranges_m[i];
    if (!(range_m >= params.min_range_m)) continue;
    const bool is_hit = range_m < params.max_range_m;
    if (is_hit && range_m > params.used_range_m) continue;
    if (!is_hit && params.cleared_m <= 0) continue;
    const double length_m = is_hit ? range_m : params.cleared_m;
    const double bearing_rad =
        beams.laser.heading_rad + beams.first_rad + static_cast<double>(i) * beams.increment_rad;
    (is_hit ? scan.hits : scan.misses)
        .push_back({scan.laser.x_m + length_m * std::cos(bearing_rad),
                    scan.laser.y_m + length_m * std::sin(bearing_rad)});
  }
  return scan;
}

Points transformed(const Points& points, const geometry::Pose& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  Points moved;
  moved.reserve(points.size());
  for (const auto& p : points) {
    moved.push_back({pose.x_m + c * p.x_m - s * p.y_m, pose.y_m + s * p.x_m + c * p.y_m});
  }
  return moved;
}

Points thinned(const Points& points, double cell_m) {
  using Square = std::pair<std::int64_t, std::int64_t>;
  std::vector<std::pair<Square, std::size_t>> squares;
  squares.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    squares.push_back({{std::llround(std::floor(points[i].x_m / cell_m)),
                        std::llround(std::floor(points[i].y_m / cell_m))},
                       i});
  }
  std::sort(squares.begin(), squares.end());
  const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
  squares.erase(std::unique(squares.begin(), squares.end(), is_same), squares.end());
  std::vector<std::size_t> kept;
  kept.reserve(squares.size());
  for (const auto& [square, index] : squares) kept.push_back(index);
  std::sort(kept.begin(), kept.end());
  Points thin;
  thin.reserve(kept.size());
  for (const std::size_t index : kept) thin.push_back(points[index]);
  return thin;
}

}  // namespace tocsin::mapping
