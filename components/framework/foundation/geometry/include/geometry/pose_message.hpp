// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/pose.hpp"

namespace tocsin::geometry {

/// The heading of a geometry_msgs/Quaternion [rad] [range -pi,pi].
template <class QuaternionMessage>
[[nodiscard]] double heading_in(const QuaternionMessage& q) {
  return heading_of({q.x(), q.y(), q.z(), q.w()});
}

/// A geometry_msgs/Pose in the plane; height, roll and pitch are ignored.
template <class PoseMessage>
[[nodiscard]] Pose pose_in(const PoseMessage& message) {
  return {message.position().x(), message.position().y(), heading_in(message.orientation())};
}

/// A pose as a geometry_msgs/Pose.
template <class PoseMessage>
[[nodiscard]] PoseMessage pose_message(const Pose& pose) {
  PoseMessage message;
  message.position().x(pose.x_m);
  message.position().y(pose.y_m);
  const Quaternion q = quaternion_of(pose.heading_rad);
  message.orientation().z(q.z);
  message.orientation().w(q.w);
  return message;
}

}  // namespace tocsin::geometry
