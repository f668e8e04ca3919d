// SPDX-License-Identifier: Apache-2.0
// The one list of actions: types and name. Both ends name the struct.
#pragma once

#include "idl_support/action_types.hpp"
#include "ros_idl/nav2_msgs.hpp"

namespace tocsin::action {

/// Drives to a pose on the map, with the distance to it as feedback.
struct NavigateToPose : ActionTypes<nav2_msgs::action::NavigateToPose_SendGoal_Request,
                                    nav2_msgs::action::NavigateToPose_SendGoal_Response,
                                    nav2_msgs::action::NavigateToPose_GetResult_Request,
                                    nav2_msgs::action::NavigateToPose_GetResult_Response,
                                    nav2_msgs::action::NavigateToPose_FeedbackMessage> {
  static constexpr const char* name = "navigate_to_pose";
};

/// Drives to one pose after the other, with the index of the present one as feedback.
struct FollowWaypoints : ActionTypes<nav2_msgs::action::FollowWaypoints_SendGoal_Request,
                                     nav2_msgs::action::FollowWaypoints_SendGoal_Response,
                                     nav2_msgs::action::FollowWaypoints_GetResult_Request,
                                     nav2_msgs::action::FollowWaypoints_GetResult_Response,
                                     nav2_msgs::action::FollowWaypoints_FeedbackMessage> {
  static constexpr const char* name = "follow_waypoints";
};

}  // namespace tocsin::action
