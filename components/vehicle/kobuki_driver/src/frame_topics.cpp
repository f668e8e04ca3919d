// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/frame_topics.hpp"

#include <utility>

#include "kobuki_driver/diagnostics.hpp"
#include "messages.hpp"

namespace tocsin {
namespace {

/// The id of the base as kobuki_node shows it: three decimal numbers.
std::string hardware_id(const kobuki::Inquiry& inquiry) {
  const auto& id = inquiry.unique_id();
  if (!id) return "Kobuki";
  return std::to_string((*id)[0]) + "-" + std::to_string((*id)[1]) + "-" + std::to_string((*id)[2]);
}

/// Makes and writes a message that somebody reads. False when it was refused.
template <class Topic, class Make>
bool offer(Output<Topic>& to, const Make& make) {
  return !to.wanted() || to.write(make()) != Status::failed;
}

}  // namespace

FrameTopics::FrameTopics(Component& owner, const FrameParams& params, bool gyro_heading)
    : owner_(owner),
      params_(params),
      odom_(owner),
      tf_(owner),
      joints_(owner),
      imu_(owner),
      battery_(owner),
      charger_(owner),
      diagnostics_(owner),
      odom_pattern_(kobuki::odom_pattern(params.odom_frame, params.base_frame, gyro_heading)) {}

builtin_interfaces::msg::Time FrameTopics::stamp(Time now) const {
  const std::int64_t ns = owner_.bus().wall_ns(now);
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(ns / 1'000'000'000));
  stamp.nanosec(static_cast<std::uint32_t>(ns % 1'000'000'000));
  return stamp;
}

std_msgs::msg::Header FrameTopics::header(Time now) const {
  std_msgs::msg::Header header;
  header.stamp(stamp(now));
  header.frame_id(params_.base_frame);
  return header;
}

bool FrameTopics::publish(const kobuki::Reading& reading, Time now) {
  bool ok = now < next_battery_ || publish_battery(reading, now);
  if (reading.pose_is_old) return ok;  // it may jump by metres with the next frame
  const kobuki::Labels labels{stamp(now), params_.odom_frame, params_.base_frame,
                              params_.wheel_left_joint_name, params_.wheel_right_joint_name};
  ok &= offer(odom_, [&] { return kobuki::odom_message(reading, odom_pattern_, labels.stamp); });
  ok &= offer(imu_, [&] { return kobuki::imu_message(reading, labels); });
  ok &= offer(joints_, [&] { return kobuki::joint_message(reading, labels); });
  if (params_.publish_tf) ok &= offer(tf_, [&] { return kobuki::tf_message(reading, labels); });
  return ok;
}

bool FrameTopics::publish_battery(const kobuki::Reading& reading, Time now) {
  next_battery_ = owner_.next_instant(seconds(params_.battery_period_s), now);
  auto message = kobuki::battery_message(reading, header(now));
  bool ok = charger_.write(message) != Status::failed;
  ok &= battery_.write(std::move(message)) != Status::failed;
  return ok;
}

bool FrameTopics::publish_diagnostics(const kobuki::KobukiDriver& driver, Time now) {
  if (now < next_diagnostics_) return true;
  next_diagnostics_ = owner_.next_instant(seconds(params_.diagnostics_period_s), now);
  if (!diagnostics_.wanted()) return true;
  topic::Diagnostics::Message message;
  message.header().stamp(stamp(now));
  const std::string id = hardware_id(driver.inquiry());
  for (const auto& diagnosis : kobuki::diagnose(driver, driver.last_reading())) {
    message.status().push_back(kobuki::to_message(diagnosis, owner_.name(), id));
  }
  return diagnostics_.write(std::move(message)) != Status::failed;
}

}  // namespace tocsin
