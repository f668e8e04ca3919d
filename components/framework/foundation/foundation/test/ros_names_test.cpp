// SPDX-License-Identifier: Apache-2.0
#include "foundation/ros_names.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

TEST(RosNames, OfTopicsLoseTheirPrefixAndPlainDdsTopicsAreNone) {
  EXPECT_EQ(ros_topic("rt/odom"), "/odom");
  EXPECT_EQ(ros_topic("rt/uxv/odom"), "/uxv/odom");
  EXPECT_EQ(ros_topic("rq/spinRequest"), std::nullopt);
  EXPECT_EQ(ros_topic("Square"), std::nullopt);
  EXPECT_EQ(ros_topic(""), std::nullopt);
}

TEST(RosNames, OfTopicsMayComeWithTheSlashOrWithout) {
  EXPECT_EQ(wire_topic("/odom"), "rt/odom");
  EXPECT_EQ(wire_topic("uxv/odom"), "rt/uxv/odom");
}

// Made before the sources of the library make theirs: the linker takes this one first.
const std::string before_main = wire_topic("/early");

TEST(RosNames, MayBeAskedForBeforeMain) { EXPECT_EQ(before_main, "rt/early"); }

TEST(RosNames, AnEmptyNameIsThePrefixAlone) {
  EXPECT_EQ(wire_topic(""), "rt/");
  EXPECT_EQ(wire_topic("/"), "rt/");
  EXPECT_EQ(ros_topic("rt/"), "/");
}

TEST(RosNames, OfTypesGoBothWays) {
  EXPECT_EQ(ros_type("nav_msgs::msg::dds_::Odometry_"), "nav_msgs/msg/Odometry");
  EXPECT_EQ(wire_type("nav_msgs/msg/Odometry"), "nav_msgs::msg::dds_::Odometry_");
  EXPECT_EQ(wire_type("nav_msgs/Odometry"), "nav_msgs::msg::dds_::Odometry_");
}

TEST(RosNames, ATypeOfAnotherShapeStaysAsItIs) {
  EXPECT_EQ(ros_type("ShapeType"), "ShapeType");
  EXPECT_EQ(ros_type("a::b::C"), "a::b::C");
}

TEST(RosNames, TypesOfServicesKeepTheirKind) {
  EXPECT_EQ(ros_type("std_srvs::srv::dds_::Empty_Request_"), "std_srvs/srv/Empty_Request");
  EXPECT_EQ(wire_type("std_srvs/srv/Empty_Request"), "std_srvs::srv::dds_::Empty_Request_");
}

TEST(RosNames, OfServicesAreTheTwoTopicsThatCarryThem) {
  const auto request = ros_service("rq/uxv/dockRequest");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->name, "/uxv/dock");
  EXPECT_EQ(request->half, ServiceHalf::request);
  EXPECT_EQ(ros_service("rr/dockReply")->half, ServiceHalf::reply);
  for (const char* other : {"rt/dockRequest", "rq/dockReply", "rq/Request", "rq/dock", ""}) {
    EXPECT_FALSE(ros_service(other)) << other;
  }
}

TEST(RosNames, TheTypeOfAServiceIsThatOfItsHalves) {
  EXPECT_EQ(ros_service_type("std_srvs::srv::dds_::Trigger_Request_"), "std_srvs/srv/Trigger");
  EXPECT_EQ(ros_service_type("std_srvs::srv::dds_::Trigger_Response_"), "std_srvs/srv/Trigger");
  EXPECT_EQ(ros_service_type("odd"), "odd");
}

TEST(RosNames, ATypeThatOnlyLooksLikeRosStaysAsItIs) {
  for (const char* odd : {"a::msg::dds_::", "a::msg::dds_::_", "a::msg::dds::B_", "a::msg::dds_::B",
                          "::", "", "x::a::msg::dds_::B_"}) {
    EXPECT_EQ(ros_type(odd), odd);
  }
}

TEST(RosNames, WhatIsNoTypeIsRefused) {
  for (const char* wrong : {"", "Odometry", "a/b/c/d", "a/b c", "/a/b"}) {
    EXPECT_THROW((void)wire_type(wrong), ConfigError) << wrong;
  }
}

}  // namespace
}  // namespace tocsin
