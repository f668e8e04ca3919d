// SPDX-License-Identifier: Apache-2.0
#include "tocsin_idl/actions.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin {
namespace {

template <class Action>
void expect_types_of_nav2(const std::string& name) {
  const std::string of = "nav2_msgs::action::dds_::" + name + "_";
  EXPECT_EQ(type_info<typename Action::SendGoalRequest>().name, of + "SendGoal_Request_");
  EXPECT_EQ(type_info<typename Action::GetResultResponse>().name, of + "GetResult_Response_");
  EXPECT_EQ(type_info<typename Action::FeedbackMessage>().name, of + "FeedbackMessage_");
  EXPECT_EQ(type_info<typename Action::Goal>().name, of + "Goal_");
  EXPECT_EQ(type_info<typename Action::Result>().name, of + "Result_");
  EXPECT_EQ(type_info<typename Action::Feedback>().name, of + "Feedback_");
}

TEST(Actions, HaveTheTypesOfNav2) {
  expect_types_of_nav2<action::NavigateToPose>("NavigateToPose");
  expect_types_of_nav2<action::FollowWaypoints>("FollowWaypoints");
}

}  // namespace
}  // namespace tocsin
