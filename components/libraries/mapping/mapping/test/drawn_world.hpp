// SPDX-License-Identifier: Apache-2.0
// Walls, a laser among them and wheels that err: everything that a mapper meets, with the truth.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "laser_geometry/scan.hpp"

namespace tocsin::mapping {

struct Segment {
  geometry::Point from;
  geometry::Point to;
};

/// Distance from `pose` to the first wall; infinity when there is none.
inline double range_to(const std::vector<Segment>& walls, const geometry::Pose& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  double nearest = infinity;
  for (const Segment& wall : walls) {
    const double ex = wall.to.x_m - wall.from.x_m;
    const double ey = wall.to.y_m - wall.from.y_m;
    const double dx = wall.from.x_m - pose.x_m;
    const double dy = wall.from.y_m - pose.y_m;
    const double cross = c * ey - s * ex;
    if (cross == 0) continue;
    const double range = (dx * ey - dy * ex) / cross;
    const double share = (dx * s - dy * c) / cross;
    if (range > 0 && share >= 0 && share <= 1) nearest = std::min(nearest, range);
  }
  return nearest;
}

/// Walls from corner to corner and back to the first.
inline std::vector<Segment> closed(const std::vector<geometry::Point>& corners) {
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
  return walls;
}

/// A room of 8 x 6 m with a niche and a pillar: it looks different from everywhere.
inline std::vector<Segment> room() {
  auto walls = closed({{0, 0}, {8, 0}, {8, 4}, {7, 4}, {7, 6}, {0, 6}});
  const auto pillar = closed({{2, 3.5}, {2.6, 3.5}, {2.6, 4.5}, {2, 4.5}});
  walls.insert(walls.end(), pillar.begin(), pillar.end());
  return walls;
}

struct Laser {
  int beams = 180;
  double view_rad = pi;
  double noise_m = 0.01;
  double range_m = 30;  ///< beams that are longer have no return
};

inline std::vector<double> ranges_of(const std::vector<Segment>& walls, const geometry::Pose& pose,
                                     const Laser& laser, std::mt19937& random) {
  std::normal_distribution<double> noise(0, laser.noise_m);
  std::vector<double> ranges;
  for (int i = 0; i < laser.beams; ++i) {
    const double bearing_rad = -laser.view_rad / 2 + i * laser.view_rad / laser.beams;
    const double range = range_to(walls, {pose.x_m, pose.y_m, pose.heading_rad + bearing_rad});
    ranges.push_back(range < laser.range_m ? std::max(0.0, range + noise(random)) : infinity);
  }
  return ranges;
}

inline Scan scan_of(const std::vector<Segment>& walls, const geometry::Pose& pose,
                    const Laser& laser, std::mt19937& random) {
  const laser::Beams beams{{}, -laser.view_rad / 2, laser.view_rad / laser.beams};
  return make_scan(ranges_of(walls, pose, laser, random), beams);
}

/// What wheels make of a step: noise, and a turn too much for each metre.
struct Wheels {
  double noise_share = 0.02;
  double noise_rad = 0.01;
  double drift_rad_per_m = 0.01;
};

inline geometry::Pose measured(const geometry::Pose& step, const Wheels& wheels,
                               std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double length_m = std::hypot(step.x_m, step.y_m);
  const double share = 1 + wheels.noise_share * normal(random);
  return {step.x_m * share, step.y_m * share,
          step.heading_rad + wheels.noise_rad * normal(random) + wheels.drift_rad_per_m * length_m};
}

/// Poses `step_m` apart along a line of corners, turning on the spot by at most `turn_rad`.
inline std::vector<geometry::Pose> drive(const std::vector<geometry::Point>& corners, double step_m,
                                         double turn_rad) {
  std::vector<geometry::Pose> poses;
  double heading_rad = geometry::bearing(corners[0], corners[1]);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double goal_rad = geometry::bearing(corners[i], corners[i + 1]);
    double left_rad = geometry::wrap_angle(goal_rad - heading_rad);
    while (std::abs(left_rad) > 1e-9) {
      heading_rad += std::clamp(left_rad, -turn_rad, turn_rad);
      poses.push_back({corners[i].x_m, corners[i].y_m, heading_rad});
      left_rad = geometry::wrap_angle(goal_rad - heading_rad);
    }
    const double length_m = geometry::distance(corners[i], corners[i + 1]);
    for (double at_m = 0; at_m < length_m; at_m += step_m) {
      const auto p = geometry::between(corners[i], corners[i + 1], at_m / length_m);
      poses.push_back({p.x_m, p.y_m, heading_rad});
    }
  }
  return poses;
}

}  // namespace tocsin::mapping
