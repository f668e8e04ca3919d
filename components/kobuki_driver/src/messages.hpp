// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kobuki_driver/kobuki_driver.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::kobuki {

/// Stamp and frames of the messages of one frame.
struct Labels {
  builtin_interfaces::msg::Time stamp;
  std::string odom_frame;
  std::string base_frame;
};

/// Stamp and base frame, for sensors in the base.
[[nodiscard]] std_msgs::msg::Header sensor_header(const Labels& labels);

/// The messages of a reading, with the covariances of the reference driver (reference page 2).
[[nodiscard]] topic::Odom::Message odom_message(const Reading& reading, const Labels& labels,
                                                bool gyro_heading);
[[nodiscard]] topic::Tf::Message tf_message(const Reading& reading, const Labels& labels);
[[nodiscard]] topic::JointStates::Message joint_message(const Reading& reading,
                                                        const Labels& labels);
[[nodiscard]] topic::Imu::Message imu_message(const Reading& reading, const Labels& labels);
[[nodiscard]] topic::BatteryState::Message battery_message(const Reading& reading,
                                                           const Labels& labels);

}  // namespace tocsin::kobuki
