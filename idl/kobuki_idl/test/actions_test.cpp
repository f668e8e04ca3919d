// SPDX-License-Identifier: Apache-2.0
#include "kobuki_idl/actions.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin {
namespace {

TEST(Actions, AutoDockingHasTheTypesOfKobukisPackage) {
  using Action = action::AutoDocking;
  const std::string of = "kobuki_ros_interfaces::action::dds_::AutoDocking_";
  EXPECT_EQ(type_info<Action::SendGoalRequest>().name, of + "SendGoal_Request_");
  EXPECT_EQ(type_info<Action::SendGoalResponse>().name, of + "SendGoal_Response_");
  EXPECT_EQ(type_info<Action::GetResultRequest>().name, of + "GetResult_Request_");
  EXPECT_EQ(type_info<Action::GetResultResponse>().name, of + "GetResult_Response_");
  EXPECT_EQ(type_info<Action::FeedbackMessage>().name, of + "FeedbackMessage_");
  EXPECT_EQ(type_info<Action::Goal>().name, of + "Goal_");
  EXPECT_EQ(type_info<Action::Result>().name, of + "Result_");
  EXPECT_EQ(type_info<Action::Feedback>().name, of + "Feedback_");
}

}  // namespace
}  // namespace tocsin
