// SPDX-License-Identifier: Apache-2.0
// The topics of a Kobuki base beside those of tocsin_idl/topics.hpp, with the names of kobuki_node.
// Apart from that list because only what meets the base includes them.
#pragma once

#include "idl_support/topic_info.hpp"
#include "kobuki_idl/kobuki_ros_interfaces.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "ros_idl/std_msgs.hpp"

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
/// Every sample of the three-axis gyro, 100 a second.
struct ImuRaw {
  using Message = sensor_msgs::msg::Imu;
  static constexpr TopicInfo info{"sensors/imu_data_raw", "sensor", Scope::host};
};
/// The same as battery_state, under the name of kobuki_node.
struct ChargerState {
  using Message = sensor_msgs::msg::BatteryState;
  static constexpr TopicInfo info{"sensors/battery_state", "sensor", Scope::host};
};
struct ControllerInfo {
  using Message = kobuki_ros_interfaces::msg::ControllerInfo;
  static constexpr TopicInfo info{"controller_info", "state", Scope::host};
};

// What the driver takes: each of them counts (masks), so events and not the newest only.

struct Led1 {
  using Message = kobuki_ros_interfaces::msg::Led;
  static constexpr TopicInfo info{"commands/led1", "event", Scope::host};
};
struct Led2 {
  using Message = kobuki_ros_interfaces::msg::Led;
  static constexpr TopicInfo info{"commands/led2", "event", Scope::host};
};
struct SoundCommand {
  using Message = kobuki_ros_interfaces::msg::Sound;
  static constexpr TopicInfo info{"commands/sound", "event", Scope::host};
};
struct DigitalOutput {
  using Message = kobuki_ros_interfaces::msg::DigitalOutput;
  static constexpr TopicInfo info{"commands/digital_output", "event", Scope::host};
};
struct ExternalPower {
  using Message = kobuki_ros_interfaces::msg::ExternalPower;
  static constexpr TopicInfo info{"commands/external_power", "event", Scope::host};
};
struct ResetOdometry {
  using Message = std_msgs::msg::Empty;
  static constexpr TopicInfo info{"commands/reset_odometry", "event", Scope::host};
};
struct MotorPower {
  using Message = kobuki_ros_interfaces::msg::MotorPower;
  static constexpr TopicInfo info{"commands/motor_power", "event", Scope::host};
};
struct GainsCommand {
  using Message = kobuki_ros_interfaces::msg::ControllerInfo;
  static constexpr TopicInfo info{"commands/controller_info", "event", Scope::host};
};

// Bytes of the serial line, for people who look for a fault; off by default.

struct RawStream {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"debug/raw_data_stream", "sensor", Scope::host};
};
struct RawCommand {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"debug/raw_data_command", "sensor", Scope::host};
};
/// Speed [mm/s] and radius [mm] of each velocity sent.
struct RawControl {
  using Message = std_msgs::msg::Int16MultiArray;
  static constexpr TopicInfo info{"debug/raw_control_command", "sensor", Scope::host};
};

using AllKobukiTopics =
    List<SensorsCore, DockInfrared, ButtonEvents, BumperEvents, CliffEvents, WheelDropEvents,
         PowerEvents, InputEvents, RobotState, VersionInfo, ImuRaw, ChargerState, ControllerInfo,
         Led1, Led2, SoundCommand, DigitalOutput, ExternalPower, ResetOdometry, MotorPower,
         GainsCommand, RawStream, RawCommand, RawControl>;

}  // namespace tocsin::topic
