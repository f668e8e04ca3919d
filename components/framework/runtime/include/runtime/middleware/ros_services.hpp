// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ros_idl/composition_interfaces.hpp"
#include "ros_idl/lifecycle_msgs.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// Names and types of the six services by which ROS 2 reads and sets parameters of a node.
namespace parameter_service {
struct DescribeParameters {
  using Request = rcl_interfaces::srv::DescribeParameters_Request;
  using Response = rcl_interfaces::srv::DescribeParameters_Response;
  static constexpr const char* name = "~/describe_parameters";
};
struct GetParameters {
  using Request = rcl_interfaces::srv::GetParameters_Request;
  using Response = rcl_interfaces::srv::GetParameters_Response;
  static constexpr const char* name = "~/get_parameters";
};
struct GetParameterTypes {
  using Request = rcl_interfaces::srv::GetParameterTypes_Request;
  using Response = rcl_interfaces::srv::GetParameterTypes_Response;
  static constexpr const char* name = "~/get_parameter_types";
};
struct ListParameters {
  using Request = rcl_interfaces::srv::ListParameters_Request;
  using Response = rcl_interfaces::srv::ListParameters_Response;
  static constexpr const char* name = "~/list_parameters";
};
struct SetParameters {
  using Request = rcl_interfaces::srv::SetParameters_Request;
  using Response = rcl_interfaces::srv::SetParameters_Response;
  static constexpr const char* name = "~/set_parameters";
};
struct SetParametersAtomically {
  using Request = rcl_interfaces::srv::SetParametersAtomically_Request;
  using Response = rcl_interfaces::srv::SetParametersAtomically_Response;
  static constexpr const char* name = "~/set_parameters_atomically";
};
}  // namespace parameter_service

/// Names and types of the five services by which ROS 2 leads a node through its lifecycle.
namespace lifecycle_service {
struct ChangeState {
  using Request = lifecycle_msgs::srv::ChangeState_Request;
  using Response = lifecycle_msgs::srv::ChangeState_Response;
  static constexpr const char* name = "~/change_state";
};
struct GetState {
  using Request = lifecycle_msgs::srv::GetState_Request;
  using Response = lifecycle_msgs::srv::GetState_Response;
  static constexpr const char* name = "~/get_state";
};
struct GetAvailableStates {
  using Request = lifecycle_msgs::srv::GetAvailableStates_Request;
  using Response = lifecycle_msgs::srv::GetAvailableStates_Response;
  static constexpr const char* name = "~/get_available_states";
};
struct GetAvailableTransitions {
  using Request = lifecycle_msgs::srv::GetAvailableTransitions_Request;
  using Response = lifecycle_msgs::srv::GetAvailableTransitions_Response;
  static constexpr const char* name = "~/get_available_transitions";
};
/// All transitions, from whatever state.
struct GetTransitionGraph : GetAvailableTransitions {
  static constexpr const char* name = "~/get_transition_graph";
};
}  // namespace lifecycle_service

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
