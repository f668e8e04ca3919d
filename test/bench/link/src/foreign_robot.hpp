// SPDX-License-Identifier: Apache-2.0
// A robot and its operator's tools that know nothing of this stack: Fast DDS with the defaults of
// its library, ROS 2's topic and type names, and nothing of the runtime.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace tocsin::bench {

/// One topic of the robot, or to it.
struct Stream {
  const char* topic;
  const char* type;
  const char* traffic_class;  ///< that config/traffic_gateway.yaml gives it
  int hz;
  bool reliable;
  bool to_robot;
};
/// Of the size of a TurtleBot 4's: a camera of 30 kB at 15 Hz, a lidar of 720 rays, odometry, and
/// velocities to it.
inline constexpr std::array<Stream, 4> streams{{
    {"rt/cmd_vel", "geometry_msgs::msg::dds_::Twist_", "critical", 10, true, true},
    {"rt/odom", "nav_msgs::msg::dds_::Odometry_", "high", 20, true, false},
    {"rt/scan", "sensor_msgs::msg::dds_::LaserScan_", "low", 10, false, false},
    {"rt/oakd/rgb/image_raw/compressed", "sensor_msgs::msg::dds_::CompressedImage_", "low", 15,
     false, false},
}};

/// What became of one stream, shared by the processes.
struct StreamLog {
  static constexpr std::size_t most = 20'000;
  std::atomic<std::uint32_t> written{0};        ///< within the window
  std::atomic<std::uint32_t> heard{0};          ///< at any time
  std::atomic<std::uint32_t> arrived{0};        ///< of those that were written within the window
  std::atomic<std::uint64_t> bytes{0};          ///< [byte] of these, serialised
  std::array<std::int64_t, most> latency_ns{};  ///< of these, in the order of arrival
  std::array<std::int64_t, most> arrived_ns{};  ///< [ns] since the epoch
};

/// Of one run, in memory that the processes share.
struct RobotLog {
  std::atomic<std::int64_t> from_ns{INT64_MAX};  ///< [ns] since the epoch, the window
  std::atomic<std::int64_t> until_ns{INT64_MAX};
  std::array<StreamLog, streams.size()> of;  ///< in the order of `streams`
};

/// Where a participant is. `peer`: IPv4 of the other one on the radio; empty: beside a router.
struct Place {
  int domain = 0;
  std::string peer = "";
};

/// Writes the streams of one side (`robot`: from the robot) and reads the others, for ever.
[[noreturn]] void be_foreign(const Place& place, bool robot, RobotLog& log);

}  // namespace tocsin::bench
