// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ros_idl/rcl_interfaces.hpp"

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

}  // namespace tocsin
