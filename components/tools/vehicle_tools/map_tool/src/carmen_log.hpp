// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laser_geometry/scan.hpp"

namespace tocsin::map_tool {

/// One turn of the laser as a log has it.
struct LogScan {
  std::vector<double> ranges_m;
  laser::Beams beams;
  double max_range_m = infinity;  ///< this and more is "no return", as far as the log says it
};

/// A reading of the odometry; some come with a scan.
struct LogReading {
  double time_s = 0;
  geometry::Pose odometry;
  std::optional<LogScan> scan;
};

/// Reads a log of CARMEN, line by line: ODOM, FLASER and ROBOTLASER1. Comments and other messages
/// (PARAM, RLASER, TRUEPOS, ...) are passed over. The text must outlive it.
///
/// FLASER does not say how its beams lie: n of them cover half a turn from -90 degrees on, an odd
/// number both ends (181, 361), an even one the first only (180, 360), as CARMEN takes it.
class CarmenLog {
 public:
  /// `name` stands in errors.
  CarmenLog(std::string_view text, std::string name);

  /// The next reading; nothing at the end. Throws ConfigError naming file, line, field, its text
  /// and what is allowed when a line of the three kinds is not as it must be.
  [[nodiscard]] std::optional<LogReading> next();

 private:
  std::string_view text_;
  std::string name_;
  std::size_t line_ = 0;
  std::optional<geometry::Point> last_;  // the odometry of the last reading
};

}  // namespace tocsin::map_tool
