// SPDX-License-Identifier: Apache-2.0
// Names of topics and types as people of ROS 2 write them, and as they stand on the wire (REP
// 2004's predecessor: design.ros2.org, "Topic and Service name mapping to DDS").
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// `rt/uxv/odom` is `/uxv/odom`; empty: no topic of ROS (a service, or a plain DDS topic).
[[nodiscard]] std::optional<std::string> ros_topic(const std::string& on_wire);

/// `/odom` and `odom` are `rt/odom`.
[[nodiscard]] std::string wire_topic(const std::string& ros_name);

/// `nav_msgs::msg::dds_::Odometry_` is `nav_msgs/msg/Odometry`; another name stays as it is.
[[nodiscard]] std::string ros_type(const std::string& on_wire);

/// `nav_msgs/msg/Odometry` and `nav_msgs/Odometry` are `nav_msgs::msg::dds_::Odometry_`. Throws
/// ConfigError for what is neither.
[[nodiscard]] std::string wire_type(const std::string& ros_name);

/// Names may come with or without the slash in front.
[[nodiscard]] std::string absolute(const std::string& ros_name);

enum class ServiceHalf { request, reply };

/// A service, and which half of it a DDS topic carries.
struct RosService {
  std::string name;
  ServiceHalf half;
};
/// `rq/uxv/dockRequest` and `rr/uxv/dockReply` are `/uxv/dock`; empty: no service of ROS.
[[nodiscard]] std::optional<RosService> ros_service(const std::string& on_wire);

/// `std_srvs::srv::dds_::Trigger_Request_` and `..._Response_` are `std_srvs/srv/Trigger`.
[[nodiscard]] std::string ros_service_type(const std::string& on_wire);

}  // namespace tocsin
