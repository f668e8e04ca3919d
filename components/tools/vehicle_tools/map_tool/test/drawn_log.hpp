// SPDX-License-Identifier: Apache-2.0
// A log of a drive round a rectangular room, with wheels that turn too much.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::map_tool {

struct DrawnLog {
  std::string text;
  std::vector<double> times_s;        ///< of every reading of the odometry
  std::vector<geometry::Pose> truth;  ///< in the frame of the first one
  std::vector<geometry::Pose> odometry;
};

/// Distance from `pose` to the walls of a room of 8 x 5 m round the origin, and to its one pillar's
/// wall from (2, 0.5) to (2, -0.5).
inline double range_in_room(const geometry::Pose& pose, double bearing_rad) {
  const double c = std::cos(pose.heading_rad + bearing_rad);
  const double s = std::sin(pose.heading_rad + bearing_rad);
  const double across = c > 0 ? (4 - pose.x_m) / c : c < 0 ? (-4 - pose.x_m) / c : infinity;
  const double along = s > 0 ? (2.5 - pose.y_m) / s : s < 0 ? (-2.5 - pose.y_m) / s : infinity;
  const double pillar = (2 - pose.x_m) / c;
  const bool hit = pillar > 0 && std::abs(pose.y_m + pillar * s) < 0.5;
  return std::min({across, along, hit ? pillar : infinity});
}

inline std::string ranges_text(const geometry::Pose& pose) {
  std::string text;
  for (int i = 0; i < 180; ++i) {
    fmt::format_to(std::back_inserter(text), " {:.3f}", range_in_room(pose, (i - 90) * degree));
  }
  return text;
}

/// 200 steps of 0.05 m on a circle; a scan each fourth step.
inline DrawnLog drawn_log() {
  DrawnLog log;
  geometry::Pose truth{0, -1.5, 0};
  geometry::Pose odometry{7, 7, 1};
  const geometry::Pose start = truth;
  for (int i = 0; i < 200; ++i) {
    const double time_s = 100 + 0.2 * i;
    const std::string pose =
        fmt::format("{:.5f} {:.5f} {:.6f}", odometry.x_m, odometry.y_m, odometry.heading_rad);
    log.text += fmt::format("ODOM {} 0.25 0.1 0 {:.6f} host {:.6f}\n", pose, time_s, time_s);
    log.times_s.push_back(time_s);
    log.truth.push_back(relative(start, truth));
    log.odometry.push_back(odometry);
    if (i % 4 == 0) {
      log.text += fmt::format("FLASER 180{} {} {} {:.6f} host {:.6f}\n", ranges_text(truth), pose,
                              pose, time_s, time_s);
    }
    truth = geometry::compose(truth, {0.05, 0, 0.05 / 1.5});
    odometry = geometry::compose(odometry, {0.05, 0, 0.05 / 1.5 + 0.003});
  }
  return log;
}

}  // namespace tocsin::map_tool
