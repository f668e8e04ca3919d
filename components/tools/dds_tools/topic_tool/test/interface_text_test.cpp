// SPDX-License-Identifier: Apache-2.0
#include "interface_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "idl_support/type_definition.hpp"
#include "idl_support/type_registry.hpp"
#include "ros_idl/example_interfaces.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<std::string> wire_names{"std_msgs::msg::dds_::String_",
                                          "std_srvs::srv::dds_::SetBool_Request_",
                                          "std_srvs::srv::dds_::SetBool_Response_",
                                          "nav::action::dds_::Go_Feedback_",
                                          "nav::action::dds_::Go_FeedbackMessage_",
                                          "nav::action::dds_::Go_GetResult_Request_",
                                          "nav::action::dds_::Go_Goal_",
                                          "nav::action::dds_::Go_SendGoal_Response_",
                                          "rmw_dds_common::humble::dds_::Gid_",
                                          "Plain"};

TEST(Interfaces, AreListedByKind) {
  const Interfaces sut = interfaces_in(wire_names);
  EXPECT_EQ(interface_list_text(sut, {}),
            "Messages:\n    std_msgs/msg/String\n"
            "Services:\n    std_srvs/srv/SetBool\n"
            "Actions:\n    nav/action/Go\n");
  EXPECT_EQ(interface_list_text(sut, {false, true, false}),
            "Services:\n    std_srvs/srv/SetBool\n");
  EXPECT_EQ(package_text(sut, "nav"), "nav/action/Go\n");
  EXPECT_EQ(package_text(sut, "na"), "");
  EXPECT_EQ(packages_text(sut), "nav\nstd_msgs\nstd_srvs\n");
}

class InterfaceText : public ::testing::Test {
 protected:
  InterfaceText() { (void)type_info<example_interfaces::action::Fibonacci_Goal>(); }
};

TEST_F(InterfaceText, AMessageIsShownWithTheFieldsOfItsPartsOneTabDeeper) {
  const auto sut = show_text("geometry_msgs/msg/Twist");
  ASSERT_TRUE(sut);
  EXPECT_THAT(*sut, StartsWith("geometry_msgs/Vector3 linear"));
  EXPECT_THAT(*sut, HasSubstr("\n\tfloat64 x"));
  EXPECT_THAT(*sut, HasSubstr("\ngeometry_msgs/Vector3 angular"));
}

TEST_F(InterfaceText, PartsOfAServiceAndOfAnActionAreDivided) {
  const auto service = show_text("std_srvs/srv/SetBool");
  ASSERT_TRUE(service);
  EXPECT_EQ(*service, "bool data\n---\nbool success\nstring message\n");
  const auto empty = show_text("std_srvs/srv/Empty");
  ASSERT_TRUE(empty);
  EXPECT_EQ(*empty, "---\n") << "what only stands on the wire is nobody's to write";
  const auto action = show_text("example_interfaces/action/Fibonacci");
  ASSERT_TRUE(action);
  EXPECT_THAT(*action, StartsWith("int32 order"));
  EXPECT_THAT(*action, HasSubstr("\n---\nint32[] sequence\n---\nint32[] sequence\n"));
}

TEST_F(InterfaceText, WhatAPersonWritesIsTheMessageTheRequestOrTheGoal) {
  EXPECT_EQ(first_part("std_msgs/msg/String"), "std_msgs::msg::dds_::String_");
  EXPECT_EQ(first_part("std_srvs/srv/SetBool"), "std_srvs::srv::dds_::SetBool_Request_");
  EXPECT_EQ(first_part("nav/action/Go"), "nav::action::dds_::Go_Goal_");
}

/// What ros2 itself takes from packages stands in our IDL.
TEST_F(InterfaceText, EveryDefinitionHasAllItsParts) {
  for (const std::string& name : known_definitions()) {
    EXPECT_TRUE(ros2msg_definition(name)) << name;
  }
}

}  // namespace
}  // namespace tocsin::topic_tool
