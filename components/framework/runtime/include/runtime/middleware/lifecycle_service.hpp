// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ros_idl/lifecycle_msgs.hpp"

namespace tocsin {

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

}  // namespace tocsin
