// SPDX-License-Identifier: Apache-2.0
#include "action_goal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "ros_idl/example_interfaces.hpp"
#include "ros_idl/nav2_msgs.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
namespace wire = example_interfaces::action;

std::string error_of(const std::string& goal) {
  try {
    (void)goal_request(KnownAction("example_interfaces/action/Fibonacci"), {}, goal);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(ActionGoal, TheRequestHasTheIdAndTheGoal) {
  (void)type_info<wire::Fibonacci_Goal>();  // whose library knows them all
  GoalId id{};
  id[0] = 200;
  id[15] = 7;
  const auto request = std::static_pointer_cast<wire::Fibonacci_SendGoal_Request>(
      goal_request(KnownAction("example_interfaces/action/Fibonacci"), id, "{order: 5}"));
  EXPECT_EQ(request->goal_id().uuid(), id);
  EXPECT_EQ(request->goal().order(), 5);
}

TEST(ActionGoal, RefusesWhatIsNoGoalByTheNameOfItsField) {
  EXPECT_THAT(error_of("{order: many}"), HasSubstr("order: 'many' is not a whole number"));
  EXPECT_THAT(error_of("{ordre: 3}"), HasSubstr("no field 'ordre'"));
  EXPECT_THAT(error_of("5"), HasSubstr("must be a map"));
}

TEST(ActionGoal, ReadsNumbersAndFieldsOfMessagesOfAnyType) {
  wire::Fibonacci_GetResult_Response message;
  message.status(4);
  message.result().sequence({0, 1, 1});
  const TypeInfo& type = type_info<wire::Fibonacci_GetResult_Response>();
  EXPECT_EQ(number_in(type, &message, "status"), 4);
  EXPECT_EQ(number_in(type, &message, "sequence"), 0);
  EXPECT_EQ(yaml_in(type, &message, "result"), "sequence:\n- 0\n- 1\n- 1\n");
  wire::Fibonacci_SendGoal_Response answer;
  answer.accepted(true);
  EXPECT_EQ(number_in(type_info<wire::Fibonacci_SendGoal_Response>(), &answer, "accepted"), 1);
}

}  // namespace
}  // namespace tocsin::topic_tool
