// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_driver/frame_topics.hpp"
#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// What only a Kobuki has, as topics with the names and types of its ROS driver: raw sensors, raw
/// gyro, dock infrared, events, versions, gains. Part of the driver's component.
class BaseTopics {
 public:
  explicit BaseTopics(Component& owner);
  /// Writes the sensors and events of a frame that came at `now`. `frames` makes the headers. False
  /// when one was refused.
  [[nodiscard]] bool publish(const kobuki::Reading& reading, const FrameTopics& frames, Time now);
  /// Writes whether the base is online.
  [[nodiscard]] bool publish_state(bool online);
  /// Writes the versions; all of them must be known.
  [[nodiscard]] bool publish_versions(const kobuki::Inquiry& inquiry);
  [[nodiscard]] bool publish_gains(const kobuki::ControllerGains& gains);

 private:
  struct EventWriter;
  [[nodiscard]] bool publish_gyro(const kobuki::RawGyro& gyro, Time now);
  [[nodiscard]] bool publish_dock(const kobuki::DockInfrared& dock,
                                  const std_msgs::msg::Header& header);

  Bus& bus_;
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
  Output<topic::ControllerInfo> gains_;
  Output<topic::ImuRaw> gyro_;
};

}  // namespace tocsin
