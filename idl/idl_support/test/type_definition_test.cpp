// SPDX-License-Identifier: Apache-2.0
#include "idl_support/type_definition.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tocsin {
namespace {

const std::string separator = std::string(80, '=') + "\n";

TEST(Ros2msgDefinition, IsTheFieldsOfATypeWithoutParts) {
  register_definition({"a::msg::dds_::Plain_", "int32 x\n", {}});
  EXPECT_EQ(ros2msg_definition("a::msg::dds_::Plain_"), "int32 x\n");
}

TEST(Ros2msgDefinition, HasAllPartsBehindItEachOnce) {
  register_definition({"b::msg::dds_::Leaf_", "int32 x\n", {}});
  register_definition({"b::msg::dds_::Inner_", "b/Leaf[] leaves\n", {"b::msg::dds_::Leaf_"}});
  register_definition({"b::msg::dds_::Outer_",
                       "b/Inner inner\nb/Leaf leaf\n",
                       {"b::msg::dds_::Inner_", "b::msg::dds_::Leaf_"}});
  EXPECT_EQ(ros2msg_definition("b::msg::dds_::Outer_"), "b/Inner inner\nb/Leaf leaf\n" + separator +
                                                            "MSG: b/Inner\nb/Leaf[] leaves\n" +
                                                            separator + "MSG: b/Leaf\nint32 x\n");
}

TEST(Ros2msgDefinition, IsNoneOfATypeThatNobodyKnows) {
  EXPECT_EQ(ros2msg_definition("c::msg::dds_::Unknown_"), std::nullopt);
  EXPECT_EQ(ros2msg_definition(""), std::nullopt);
}

TEST(Ros2msgDefinition, IsNoneWhenAPartIsMissing) {
  register_definition({"d::msg::dds_::Outer_", "d/Gone gone\n", {"d::msg::dds_::Gone_"}});
  EXPECT_EQ(ros2msg_definition("d::msg::dds_::Outer_"), std::nullopt);
}

TEST(Ros2msgDefinition, OfTwoUnderOneNameTheFirstStands) {
  register_definition({"e::msg::dds_::Twice_", "int32 x\n", {}});
  register_definition({"e::msg::dds_::Twice_", "int32 y\n", {}});
  EXPECT_EQ(ros2msg_definition("e::msg::dds_::Twice_"), "int32 x\n");
}

TEST(Definitions, AreFoundByTheirWireNameAndListed) {
  register_definition({"f::srv::dds_::Ask_Request_", "int32 x\n", {"f::msg::dds_::Part_"}});
  const auto found = find_definition("f::srv::dds_::Ask_Request_");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "int32 x\n");
  EXPECT_EQ(found->parts, std::vector<std::string>{"f::msg::dds_::Part_"});
  EXPECT_FALSE(find_definition("f::srv::dds_::Ask_Response_"));
  const auto all = known_definitions();
  EXPECT_NE(std::find(all.begin(), all.end(), "f::srv::dds_::Ask_Request_"), all.end());
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
}

TEST(Definitions, FieldsCallATypeByItsPackageAndItsName) {
  EXPECT_EQ(short_type_name("geometry_msgs::msg::dds_::Twist_"), "geometry_msgs/Twist");
  EXPECT_EQ(short_type_name("n::action::dds_::Go_Goal_"), "n/Go_Goal");
}

}  // namespace
}  // namespace tocsin
