// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/pose.hpp"
#include "ros_idl/geometry_msgs.hpp"

namespace tocsin {

[[nodiscard]] inline geometry::Pose pose_of(const geometry_msgs::msg::Pose& message) {
  const auto& q = message.orientation();
  return {message.position().x(), message.position().y(),
          geometry::heading_of({q.x(), q.y(), q.z(), q.w()})};
}

[[nodiscard]] inline geometry_msgs::msg::Pose to_msg(const geometry::Pose& pose) {
  geometry_msgs::msg::Pose message;
  message.position().x(pose.x_m);
  message.position().y(pose.y_m);
  const auto q = geometry::quaternion_of(pose.heading_rad);
  message.orientation().z(q.z);
  message.orientation().w(q.w);
  return message;
}

}  // namespace tocsin
