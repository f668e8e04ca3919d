// SPDX-License-Identifier: Apache-2.0
#include "laser_geometry/scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace tocsin::laser {
namespace {

using geometry::Point;
using geometry::Pose;

constexpr double longest_gap_m = 1.5;  // farther apart, two hits are of two things
constexpr double straight = 0.2;       // [rad] within it three hits are of one wall

bool is_straight(const Point& a, const Point& b, const Point& c) {
  if (geometry::distance(a, b) > longest_gap_m || geometry::distance(b, c) > longest_gap_m) {
    return false;
  }
  const double turn_rad = geometry::bearing(b, c) - geometry::bearing(a, b);
  return std::abs(geometry::wrap_angle(turn_rad)) < straight;
}

bool is_standing(const geometry::Twist& velocity) {
  return velocity.linear_mps == 0 && velocity.angular_rad_s == 0;
}

/// Where a vehicle is after `dt_s`, from the origin, on an arc.
Pose moved(const geometry::Twist& velocity, double dt_s) {
  const double turn_rad = velocity.angular_rad_s * dt_s;
  const double way_m = velocity.linear_mps * dt_s;
  return {way_m * std::cos(turn_rad / 2), way_m * std::sin(turn_rad / 2), turn_rad};
}

bool is_used(double range_m, const ScanParams& params) {
  if (!(range_m >= params.min_range_m)) return false;
  if (range_m < params.max_range_m) return range_m <= params.used_range_m;
  return params.cleared_m > 0;
}

/// For each beam, how many in a row with it have no return; 0 for one that has.
std::vector<std::size_t> runs_without_return(const std::vector<double>& ranges_m,
                                             double max_range_m) {
  std::vector<std::size_t> runs(ranges_m.size(), 0);
  for (std::size_t first = 0; first < ranges_m.size(); ++first) {
    std::size_t end = first;
    while (end < ranges_m.size() && ranges_m[end] >= max_range_m) ++end;
    std::fill(runs.begin() + static_cast<std::ptrdiff_t>(first),
              runs.begin() + static_cast<std::ptrdiff_t>(end), end - first);
    first = std::max(first, end);
  }
  return runs;
}

/// How nearly a beam measures what it or its neighbours measured before; NaN: one of both is none.
float change_of(const std::vector<float>& before_m, std::size_t beam, float range_m) {
  const std::size_t count = before_m.size();
  float least_m = std::abs(range_m - before_m[beam]);
  for (const std::size_t neighbour : {(beam + 1) % count, (beam + count - 1) % count}) {
    least_m = std::fmin(least_m, std::abs(range_m - before_m[neighbour]));
  }
  return least_m;
}

}  // namespace

Scan make_scan(const std::vector<double>& ranges_m, const Beams& beams, const ScanParams& params) {
  Scan scan;
  scan.laser = geometry::position(beams.laser);
  scan.ranges_m.assign(ranges_m.size(), std::numeric_limits<float>::quiet_NaN());
  const std::vector<std::size_t> run = runs_without_return(ranges_m, params.max_range_m);
  const bool moves = beams.interval_s != 0 && !is_standing(beams.velocity);
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const double range_m = ranges_m[i];
    if (!is_used(range_m, params)) continue;
    const bool is_hit = range_m < params.max_range_m;
    const double length_m = is_hit ? range_m : params.cleared_m;
    if (is_hit) scan.ranges_m[i] = static_cast<float>(range_m);
    const auto beam = static_cast<double>(i);
    const Pose laser =
        moves ? compose(moved(beams.velocity, beam * beams.interval_s), beams.laser) : beams.laser;
    const double bearing_rad = laser.heading_rad + beams.first_rad + beam * beams.increment_rad;
    const Point end{laser.x_m + length_m * std::cos(bearing_rad),
                    laser.y_m + length_m * std::sin(bearing_rad)};
    (is_hit ? scan.hits : scan.misses).push_back(end);
    if (!is_hit && run[i] >= params.open_beams) scan.open.push_back(end);
  }
  return scan;
}

bool is_repeated(const Scan& before, const Scan& now) {
  constexpr float same_m = 0.0002F;
  constexpr int least = 8;
  if (before.ranges_m.size() != now.ranges_m.size()) return false;
  int common = 0;
  int same = 0;
  for (std::size_t i = 0; i < now.ranges_m.size(); ++i) {
    const float change_m = change_of(before.ranges_m, i, now.ranges_m[i]);
    if (std::isnan(change_m)) continue;
    ++common;
    if (change_m < same_m) ++same;
  }
  return common >= least && same >= 0.85 * common;
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

Points joined(const Points& hits, double spacing_m) {
  Points filled;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    filled.push_back(hits[i]);
    if (i + 1 == hits.size()) break;
    const double gap_m = geometry::distance(hits[i], hits[i + 1]);
    if (gap_m <= spacing_m || gap_m > longest_gap_m) continue;
    const bool goes_on = i > 0 && is_straight(hits[i - 1], hits[i], hits[i + 1]);
    const bool begins = i + 2 < hits.size() && is_straight(hits[i], hits[i + 1], hits[i + 2]);
    if (!goes_on && !begins) continue;
    const double parts = std::ceil(gap_m / spacing_m);
    for (double k = 1; k < parts; ++k) {
      filled.push_back(geometry::between(hits[i], hits[i + 1], k / parts));
    }
  }
  return filled;
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

}  // namespace tocsin::laser
