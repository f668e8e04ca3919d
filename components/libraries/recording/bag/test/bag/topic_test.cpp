// SPDX-License-Identifier: Apache-2.0
#include "bag/topic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "idl_support/topic_registry.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::bag {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(BagTopic, HasTheNamesOfRos) {
  const Topic topic = make_topic("rt/uxv/odom", "nav_msgs::msg::dds_::Odometry_");
  EXPECT_EQ(topic.name, "/uxv/odom");
  EXPECT_EQ(topic.type, "nav_msgs/msg/Odometry");
  EXPECT_EQ(topic.serialization_format, "cdr");
}

TEST(BagTopic, HasTheDefinitionOfItsTypeWithAllParts) {
  (void)type_info<nav_msgs::msg::Odometry>();
  const Topic topic = make_topic("rt/odom", "nav_msgs::msg::dds_::Odometry_");
  EXPECT_EQ(topic.definition_encoding, "ros2msg");
  EXPECT_THAT(topic.definition, StartsWith("std_msgs/Header header\n"));
  EXPECT_THAT(topic.definition, HasSubstr("MSG: geometry_msgs/Quaternion\nfloat64 x"));
}

TEST(BagTopic, OfAnUnknownTypeHasItsNameAndNoDefinition) {
  const Topic topic = make_topic("rt/x", "acme_msgs::msg::dds_::Widget_");
  EXPECT_EQ(topic.type, "acme_msgs/msg/Widget");
  EXPECT_EQ(topic.definition_encoding, "");
  EXPECT_EQ(topic.definition, "");
}

TEST(BagTopic, OfPlainDdsKeepsItsNames) {
  const Topic topic = make_topic("Square", "ShapeType");
  EXPECT_EQ(topic.name, "Square");
  EXPECT_EQ(topic.type, "ShapeType");
}

TEST(BagTopic, OfEveryTopicOfThisRepositoryHasADefinition) {
  (void)type_info<tocsin_msgs::msg::Goal>();  // so that its library is linked
  std::set<std::string> types;
  for (const KnownTopic& known : known_topics()) {
    types.insert(known.type->name);
    EXPECT_EQ(make_topic("rt/x", known.type->name).definition_encoding, "ros2msg")
        << known.type->name;
  }
  EXPECT_GT(types.size(), 20U);
}

}  // namespace
}  // namespace tocsin::bag
