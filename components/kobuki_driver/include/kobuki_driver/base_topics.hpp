// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// What only a Kobuki has, as topics with the names and types of its ROS driver: raw sensors, dock
/// infrared, events, versions. Part of the driver's component.
class BaseTopics {
 public:
  explicit BaseTopics(Component& owner);
  /// Writes one frame's sensors and events. False when one of them was refused.
  [[nodiscard]] bool publish(const kobuki::Reading& reading, const std_msgs::msg::Header& header);
  /// Writes whether the base is online.
  [[nodiscard]] bool publish_state(bool online);
  /// Writes the versions once they are known.
  [[nodiscard]] bool publish_versions(const kobuki::Inquiry& inquiry);

 private:
  struct EventWriter;
  Output<topic::SensorsCore> sensors_;
  Output<topic::DockInfrared> dock_;
  Output<topic::ButtonEvents> buttons_;
  Output<topic::BumperEvents> bumpers_;
  Output<topic::CliffEvents> cliffs_;
  Output<topic::WheelDropEvents> wheels_;
  Output<topic::PowerEvents> power_;
  Output<topic::InputEvents> inputs_;
  Output<topic::RobotState> robot_state_;
  Output<topic::VersionInfo> versions_;
};

}  // namespace tocsin
