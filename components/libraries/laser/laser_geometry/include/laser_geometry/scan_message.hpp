// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "laser_geometry/scan.hpp"

namespace tocsin::laser {

/// A sensor_msgs/LaserScan as points in the frame of the vehicle at the message's stamp, which is
/// that of its first beam. `laser` is the place of its frame on the vehicle, `velocity` that of the
/// vehicle. Beams may be told backwards in time. The ranges that the message allows narrow those of
/// `params`. Empty when the message is none: no readings, or angles, times and ranges that are not
/// finite or contradict each other.
template <class LaserScan>
[[nodiscard]] std::optional<Scan> scan_of(const LaserScan& message, const geometry::Pose& laser,
                                          const geometry::Twist& velocity, ScanParams params = {}) {
  Beams beams{laser, message.angle_min(), message.angle_increment(), message.time_increment(),
              velocity};
  const double turn_rad = beams.increment_rad * static_cast<double>(message.ranges().size());
  const bool is_valid = !message.ranges().empty() && std::isfinite(beams.first_rad) &&
                        std::isfinite(turn_rad) && std::abs(turn_rad) < 2.1 * pi &&
                        std::abs(beams.interval_s) < 1 && message.range_min() >= 0 &&
                        message.range_max() > message.range_min();
  if (!is_valid) return std::nullopt;
  params.min_range_m = std::max(params.min_range_m, static_cast<double>(message.range_min()));
  params.max_range_m = std::min(params.max_range_m, static_cast<double>(message.range_max()));
  return make_scan({message.ranges().begin(), message.ranges().end()}, beams, params);
}

}  // namespace tocsin::laser
