// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <cmath>
#include <limits>

#include "kobuki_protocol/gyro.hpp"

namespace tocsin::kobuki {
namespace {

constexpr double unused = 1e10;
constexpr double unused_imu = std::numeric_limits<double>::max();

std_msgs::msg::Header header(const builtin_interfaces::msg::Time& stamp, const std::string& frame) {
  std_msgs::msg::Header header;
  header.stamp(stamp);
  header.frame_id(frame);
  return header;
}

geometry_msgs::msg::Quaternion quaternion(double heading_rad) {
  const geometry::Quaternion rotation = geometry::quaternion_of(heading_rad);
  geometry_msgs::msg::Quaternion q;
  q.x(rotation.x);
  q.y(rotation.y);
  q.z(rotation.z);
  q.w(rotation.w);
  return q;
}

std::uint8_t status_of(ChargingState state) {
  namespace constants = sensor_msgs::msg::BatteryState_Constants;
  switch (state) {
    case ChargingState::charged:
      return constants::POWER_SUPPLY_STATUS_FULL;
    case ChargingState::charging:
      return constants::POWER_SUPPLY_STATUS_CHARGING;
    case ChargingState::discharging:
      break;
  }
  return constants::POWER_SUPPLY_STATUS_DISCHARGING;
}

}  // namespace

topic::Odom::Message odom_pattern(const std::string& odom_frame, const std::string& base_frame,
                                  bool gyro_heading) {
  topic::Odom::Message message;
  message.header().frame_id(odom_frame);
  message.child_frame_id(base_frame);
  auto& covariance = message.pose().covariance();
  covariance.fill(0);
  covariance[0] = covariance[7] = 0.1;
  covariance[14] = covariance[21] = covariance[28] = unused;
  covariance[35] = gyro_heading ? 0.05 : 0.2;
  message.twist().covariance().fill(0);
  return message;
}

std::shared_ptr<const topic::Odom::Message> odom_message(
    const Reading& reading, const topic::Odom::Message& pattern,
    const builtin_interfaces::msg::Time& stamp) {
  auto message = std::make_shared<topic::Odom::Message>(pattern);
  message->header().stamp(stamp);
  auto& pose = message->pose().pose();
  pose.position().x(reading.pose.x_m);
  pose.position().y(reading.pose.y_m);
  pose.orientation(quaternion(reading.pose.heading_rad));
  auto& twist = message->twist().twist();
  twist.linear().x(reading.linear_mps);
  twist.angular().z(reading.angular_rad_s);
  return message;
}

std::shared_ptr<const topic::Tf::Message> tf_message(const Reading& reading, const Labels& labels) {
  geometry_msgs::msg::TransformStamped transform;
  transform.header(header(labels.stamp, labels.odom_frame));
  transform.child_frame_id(labels.base_frame);
  transform.transform().translation().x(reading.pose.x_m);
  transform.transform().translation().y(reading.pose.y_m);
  transform.transform().rotation(quaternion(reading.pose.heading_rad));
  auto message = std::make_shared<topic::Tf::Message>();
  message->transforms().push_back(transform);
  return message;
}

std::shared_ptr<const topic::JointStates::Message> joint_message(const Reading& reading,
                                                                 const Labels& labels) {
  auto message = std::make_shared<topic::JointStates::Message>();
  message->header(header(labels.stamp, ""));
  message->name({labels.left_joint, labels.right_joint});
  message->position({reading.left.angle_rad, reading.right.angle_rad});
  message->velocity({reading.left.rate_rad_s, reading.right.rate_rad_s});
  return message;
}

std::shared_ptr<const topic::Imu::Message> imu_message(const Reading& reading,
                                                       const Labels& labels) {
  auto message = std::make_shared<topic::Imu::Message>();
  message->header(header(labels.stamp, "gyro_link"));
  message->orientation(quaternion(reading.gyro_heading_rad));
  message->angular_velocity().z(reading.gyro_rate_rad_s);
  for (auto* covariance :
       {&message->orientation_covariance(), &message->angular_velocity_covariance()}) {
    covariance->fill(0);
    (*covariance)[0] = (*covariance)[4] = unused_imu;
    (*covariance)[8] = 0.05;
  }
  message->linear_acceleration_covariance().fill(0);
  message->linear_acceleration_covariance()[0] = -1;  // ROS: there is no such measurement
  return message;
}

topic::Imu::Message raw_imu_message(const RawGyro::Sample& sample, std::int64_t wall_ns) {
  const AngularVelocity rate = angular_velocity(sample);
  topic::Imu::Message message;
  message.header().stamp().sec(static_cast<std::int32_t>(wall_ns / 1'000'000'000));
  message.header().stamp().nanosec(static_cast<std::uint32_t>(wall_ns % 1'000'000'000));
  message.header().frame_id("gyro_link");
  message.angular_velocity().x(rate.x_rad_s);
  message.angular_velocity().y(rate.y_rad_s);
  message.angular_velocity().z(rate.z_rad_s);
  message.angular_velocity_covariance().fill(0);
  for (auto* absent :
       {&message.orientation_covariance(), &message.linear_acceleration_covariance()}) {
    absent->fill(0);
    (*absent)[0] = -1;  // ROS: there is no such measurement
  }
  return message;
}

diagnostic_msgs::msg::DiagnosticStatus to_message(const Diagnosis& diagnosis,
                                                  const std::string& owner,
                                                  const std::string& hardware_id) {
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level(static_cast<std::uint8_t>(diagnosis.level));
  status.name(owner + ": " + diagnosis.name);
  status.message(diagnosis.message);
  status.hardware_id(hardware_id);
  for (const auto& [key, value] : diagnosis.values) {
    diagnostic_msgs::msg::KeyValue entry;
    entry.key(key);
    entry.value(value);
    status.values().push_back(std::move(entry));
  }
  return status;
}

topic::BatteryState::Message battery_message(const Reading& reading,
                                             const std_msgs::msg::Header& header) {
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  topic::BatteryState::Message message;
  message.header(header);
  message.voltage(static_cast<float>(reading.battery.voltage_v));
  message.percentage(static_cast<float>(reading.battery.percentage));
  message.temperature(unknown);
  message.current(unknown);
  message.charge(unknown);
  message.capacity(unknown);
  message.design_capacity(unknown);
  message.power_supply_status(status_of(reading.battery.state));
  message.power_supply_health(sensor_msgs::msg::BatteryState_Constants::POWER_SUPPLY_HEALTH_GOOD);
  message.power_supply_technology(
      sensor_msgs::msg::BatteryState_Constants::POWER_SUPPLY_TECHNOLOGY_LION);
  message.present(true);
  message.location("base");
  return message;
}

}  // namespace tocsin::kobuki
