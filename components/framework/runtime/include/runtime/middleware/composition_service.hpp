// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ros_idl/composition_interfaces.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// Names and types of the three services by which ROS 2 puts nodes into a running container, and of
/// the one by which we change its QoS: ROS 2 has none for that.
namespace composition_service {
struct LoadNode {
  using Request = composition_interfaces::srv::LoadNode_Request;
  using Response = composition_interfaces::srv::LoadNode_Response;
  static constexpr const char* name = "~/_container/load_node";
};
struct UnloadNode {
  using Request = composition_interfaces::srv::UnloadNode_Request;
  using Response = composition_interfaces::srv::UnloadNode_Response;
  static constexpr const char* name = "~/_container/unload_node";
};
struct ListNodes {
  using Request = composition_interfaces::srv::ListNodes_Request;
  using Response = composition_interfaces::srv::ListNodes_Response;
  static constexpr const char* name = "~/_container/list_nodes";
};
struct SetQos {
  using Request = tocsin_msgs::srv::SetQos_Request;
  using Response = tocsin_msgs::srv::SetQos_Response;
  static constexpr const char* name = "~/_container/set_qos";
};
}  // namespace composition_service

}  // namespace tocsin
