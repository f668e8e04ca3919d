// SPDX-License-Identifier: Apache-2.0
// The topics of a Kobuki base beside those of tocsin_idl/topics.hpp, with the names of kobuki_node.
// Apart from that list because only what meets the base includes them.
#pragma once

#include "idl_support/topic_info.hpp"
#include "kobuki_idl/kobuki_ros_interfaces.hpp"

namespace tocsin::topic {

struct SensorsCore {
  using Message = kobuki_ros_interfaces::msg::SensorState;
  static constexpr TopicInfo info{"sensors/core", "sensor", Scope::host};
};
struct DockInfrared {
  using Message = kobuki_ros_interfaces::msg::DockInfraRed;
  static constexpr TopicInfo info{"sensors/dock_ir", "sensor", Scope::host};
};
struct ButtonEvents {
  using Message = kobuki_ros_interfaces::msg::ButtonEvent;
  static constexpr TopicInfo info{"events/button", "event", Scope::host};
};
struct BumperEvents {
  using Message = kobuki_ros_interfaces::msg::BumperEvent;
  static constexpr TopicInfo info{"events/bumper", "event", Scope::host};
};
struct CliffEvents {
  using Message = kobuki_ros_interfaces::msg::CliffEvent;
  static constexpr TopicInfo info{"events/cliff", "event", Scope::host};
};
struct WheelDropEvents {
  using Message = kobuki_ros_interfaces::msg::WheelDropEvent;
  static constexpr TopicInfo info{"events/wheel_drop", "event", Scope::host};
};
struct PowerEvents {
  using Message = kobuki_ros_interfaces::msg::PowerSystemEvent;
  static constexpr TopicInfo info{"events/power_system", "event", Scope::host};
};
struct InputEvents {
  using Message = kobuki_ros_interfaces::msg::DigitalInputEvent;
  static constexpr TopicInfo info{"events/digital_input", "event", Scope::host};
};
struct RobotState {
  using Message = kobuki_ros_interfaces::msg::RobotStateEvent;
  static constexpr TopicInfo info{"events/robot_state", "state", Scope::host};
};
struct VersionInfo {
  using Message = kobuki_ros_interfaces::msg::VersionInfo;
  static constexpr TopicInfo info{"version_info", "state", Scope::host};
};

}  // namespace tocsin::topic
