// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "kobuki_driver/diagnostics.hpp"
#include "kobuki_driver/kobuki_driver.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::kobuki {

/// Stamp and names in the messages of one frame. The names live longer.
struct Labels {
  builtin_interfaces::msg::Time stamp;
  const std::string& odom_frame;
  const std::string& base_frame;
  const std::string& left_joint;
  const std::string& right_joint;
};

/// What all odometry messages have in common, with the covariances of the reference driver
/// (reference page 2).
[[nodiscard]] topic::Odom::Message odom_pattern(const std::string& odom_frame,
                                                const std::string& base_frame, bool gyro_heading);
/// The messages of a reading.
[[nodiscard]] std::shared_ptr<const topic::Odom::Message> odom_message(
    const Reading& reading, const topic::Odom::Message& pattern,
    const builtin_interfaces::msg::Time& stamp);
[[nodiscard]] std::shared_ptr<const topic::Tf::Message> tf_message(const Reading& reading,
                                                                   const Labels& labels);
[[nodiscard]] std::shared_ptr<const topic::JointStates::Message> joint_message(
    const Reading& reading, const Labels& labels);
/// Heading and rate of the gyro, also when odometry follows the encoders.
[[nodiscard]] std::shared_ptr<const topic::Imu::Message> imu_message(const Reading& reading,
                                                                     const Labels& labels);
/// One sample of the raw gyro, taken at `wall_ns` since the Unix epoch.
[[nodiscard]] topic::Imu::Message raw_imu_message(const RawGyro::Sample& sample,
                                                  std::int64_t wall_ns);
[[nodiscard]] diagnostic_msgs::msg::DiagnosticStatus to_message(const Diagnosis& diagnosis,
                                                                const std::string& owner,
                                                                const std::string& hardware_id);
[[nodiscard]] topic::BatteryState::Message battery_message(const Reading& reading,
                                                           const std_msgs::msg::Header& header);

}  // namespace tocsin::kobuki
