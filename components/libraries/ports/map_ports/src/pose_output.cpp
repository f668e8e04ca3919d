// SPDX-License-Identifier: Apache-2.0
#include "map_ports/pose_output.hpp"

#include <utility>

#include "geometry/pose_message.hpp"

namespace tocsin {

builtin_interfaces::msg::Time stamp_of(std::int64_t ns) {
  constexpr std::int64_t ns_per_s = 1'000'000'000;
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(ns / ns_per_s));
  stamp.nanosec(static_cast<std::uint32_t>(ns % ns_per_s));
  return stamp;
}

PoseOutput::PoseOutput(Component& owner)
    : pose_(owner), tf_(owner), log_(owner.name(), owner.node()) {}

void PoseOutput::publish_pose(const geometry::Pose& pose, const Covariance& covariance,
                              const builtin_interfaces::msg::Time& stamp) {
  topic::AmclPose::Message message;
  message.header().stamp(stamp);
  message.header().frame_id("map");
  message.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(pose));
  constexpr std::array<std::size_t, 3> rows{0, 1, 5};  // x, y, heading of six
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      message.pose().covariance()[6 * rows[i] + rows[k]] = covariance[3 * i + k];
    }
  }
  if (pose_.write(std::move(message)) == Status::failed) log_.warn("a pose was not sent");
}

void PoseOutput::publish_transform(const geometry::Pose& map_from_odom,
                                   const builtin_interfaces::msg::Time& stamp) {
  geometry_msgs::msg::TransformStamped transform;
  transform.header().stamp(stamp);
  transform.header().frame_id("map");
  transform.child_frame_id("odom");
  transform.transform().translation().x(map_from_odom.x_m);
  transform.transform().translation().y(map_from_odom.y_m);
  const geometry::Quaternion turned = geometry::quaternion_of(map_from_odom.heading_rad);
  transform.transform().rotation().z(turned.z);
  transform.transform().rotation().w(turned.w);
  topic::Tf::Message transforms;
  transforms.transforms().push_back(transform);
  if (tf_.write(std::move(transforms)) == Status::failed) log_.warn("a transform was not sent");
}

}  // namespace tocsin
