// SPDX-License-Identifier: Apache-2.0
// Actions of a Kobuki base: types and name. Both ends name the struct.
#pragma once

#include "idl_support/action_types.hpp"
#include "kobuki_idl/kobuki_ros_interfaces.hpp"

namespace tocsin::action {

/// Drives into the charging dock; the goal says nothing more.
struct AutoDocking : ActionTypes<kobuki_ros_interfaces::action::AutoDocking_SendGoal_Request,
                                 kobuki_ros_interfaces::action::AutoDocking_SendGoal_Response,
                                 kobuki_ros_interfaces::action::AutoDocking_GetResult_Request,
                                 kobuki_ros_interfaces::action::AutoDocking_GetResult_Response,
                                 kobuki_ros_interfaces::action::AutoDocking_FeedbackMessage> {
  static constexpr const char* name = "auto_docking_action";
};

}  // namespace tocsin::action
