// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "kobuki_idl/topics.hpp"
#include "navigator/navigator.hpp"
#include "runtime/port.hpp"
#include "scan_input/pose_history.hpp"
#include "scan_input/scan_input.hpp"

namespace tocsin {

/// The ports by which a navigator knows of obstacles: the laser's scans, bumps and cliffs.
class ObstacleInputs {
 public:
  explicit ObstacleInputs(Component& owner);

  /// Where the vehicle was on the map at the stamp of an odometry message, and how it moves.
  void on_pose(std::int64_t stamp_ns, const geometry::Pose& pose, const geometry::Twist& velocity);
  /// Hands on what has been received.
  void take(Navigator& navigator, Time now);

 private:
  ScanInput scan_;
  OptionalInput<topic::BumperEvents> bumper_;
  OptionalInput<topic::CliffEvents> cliff_;
  PoseHistory poses_;
  geometry::Twist velocity_;
};

}  // namespace tocsin
