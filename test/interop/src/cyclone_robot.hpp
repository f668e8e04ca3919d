// SPDX-License-Identifier: Apache-2.0
// A robot and its operator's tools on Cyclone DDS, as rmw_cyclonedds has them: ROS 2's topic and
// type names, no configuration, and nothing of this stack.
#pragma once

#include <string>

namespace tocsin::interop {

enum class Side { robot, station };

/// Where its samples are told: a line `TOPIC HASH BYTES` for each, of its bytes on the wire.
struct RobotLogs {
  std::string sent;
  std::string heard;
};

/// Names of the topics: velocities to the robot, its lidar and its camera.
inline constexpr const char* velocities = "rt/cmd_vel";
inline constexpr const char* scans = "rt/scan";
inline constexpr const char* pictures = "rt/oakd/rgb/image_raw/compressed";

/// Writes the topics of one side ten times a second and hears the others, for ever.
[[noreturn]] void be_cyclone_robot(Side side, int domain, const RobotLogs& logs);

}  // namespace tocsin::interop
