// SPDX-License-Identifier: Apache-2.0
#include "tocsin_idl/actions.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin {
namespace {

TEST(Actions, NavigateToPoseHasTheTypesOfNav2) {
  using Action = action::NavigateToPose;
  const std::string of = "nav2_msgs::action::dds_::NavigateToPose_";
  EXPECT_EQ(type_info<Action::SendGoalRequest>().name, of + "SendGoal_Request_");
  EXPECT_EQ(type_info<Action::GetResultResponse>().name, of + "GetResult_Response_");
  EXPECT_EQ(type_info<Action::FeedbackMessage>().name, of + "FeedbackMessage_");
  EXPECT_EQ(type_info<Action::Goal>().name, of + "Goal_");
  EXPECT_EQ(type_info<Action::Result>().name, of + "Result_");
  EXPECT_EQ(type_info<Action::Feedback>().name, of + "Feedback_");
}

}  // namespace
}  // namespace tocsin
