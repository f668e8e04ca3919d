// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

struct FrameParams {
  double battery_period_s = 1.0;
  double diagnostics_period_s = 1.0;
  bool publish_tf = true;
  std::string odom_frame = "odom";
  std::string base_frame = "base_footprint";
  std::string wheel_left_joint_name = "wheel_left_joint";
  std::string wheel_right_joint_name = "wheel_right_joint";
  template <class Visitor>
  void visit(Visitor& v) {
    v("battery_period_s", battery_period_s, {0.02, 60}, "[s] between battery states");
    v("diagnostics_period_s", diagnostics_period_s, {0.1, 60}, "[s] between diagnostics");
    v("publish_tf", publish_tf, "publishes the transform from odom to base");
    v("odom_frame", odom_frame, "frame of odometry");
    v("base_frame", base_frame, "frame of the base");
    v("wheel_left_joint_name", wheel_left_joint_name, "in joint_states");
    v("wheel_right_joint_name", wheel_right_joint_name, "in joint_states");
  }
};

/// What any driven base has, as topics: odometry, transform, joints, heading, battery, health.
/// Part of the driver's component.
class FrameTopics {
 public:
  FrameTopics(Component& owner, const FrameParams& params, bool gyro_heading);
  /// Writes what a frame that came at `now` tells. False when something was refused.
  [[nodiscard]] bool publish(const kobuki::Reading& reading, Time now);
  /// Writes the diagnostics when they are due, also of a base that is away.
  [[nodiscard]] bool publish_diagnostics(const kobuki::KobukiDriver& driver, Time now);
  [[nodiscard]] Time next_diagnostics() const { return next_diagnostics_; }
  [[nodiscard]] std_msgs::msg::Header header(Time now) const;

 private:
  [[nodiscard]] builtin_interfaces::msg::Time stamp(Time now) const;
  [[nodiscard]] bool publish_battery(const kobuki::Reading& reading, Time now);

  Component& owner_;
  FrameParams params_;
  Output<topic::Odom> odom_;
  Output<topic::Tf> tf_;
  Output<topic::JointStates> joints_;
  Output<topic::Imu> imu_;
  Output<topic::BatteryState> battery_;
  Output<topic::ChargerState> charger_;
  Output<topic::Diagnostics> diagnostics_;
  const topic::Odom::Message odom_pattern_;
  Time next_battery_ = Time::min();
  Time next_diagnostics_ = Time::min();
};

}  // namespace tocsin
