// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carmen_log.hpp"
#include "mapping/mapper.hpp"

namespace tocsin::map_tool {

/// A pose on the map, and when.
struct TimedPose {
  double time_s = 0;
  geometry::Pose pose;
};

/// Maps a log, reading by reading.
class Replay {
 public:
  explicit Replay(const mapping::MapperParams& params = {},
                  const laser::ScanParams& scan_params = {});

  void on_reading(const LogReading& reading);
  /// After the last reading.
  void finish() { mapper_.finish(); }

  /// The pose at each reading of the odometry, in the order of the log. Between scans that were
  /// used the odometry leads from one to the next, its misfit spread over the way.
  [[nodiscard]] std::vector<TimedPose> trajectory() const;
  [[nodiscard]] const mapping::Mapper& mapper() const { return mapper_; }
  [[nodiscard]] std::size_t scans() const { return scans_; }

 private:
  struct Reading {
    double time_s = 0;
    geometry::Pose odometry;
    bool is_node = false;
  };
  void add_between(const std::vector<Reading>& readings, std::size_t node,
                   std::vector<TimedPose>& trajectory) const;

  laser::ScanParams scan_params_;
  mapping::Mapper mapper_;
  std::vector<Reading> readings_;
  std::size_t scans_ = 0;
};

/// Lines `time x y theta` [s, m, m, rad].
[[nodiscard]] std::string trajectory_text(const std::vector<TimedPose>& trajectory);

}  // namespace tocsin::map_tool
