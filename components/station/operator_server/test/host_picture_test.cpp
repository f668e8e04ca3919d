// SPDX-License-Identifier: Apache-2.0
#include "operator_server/host_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ros_idl/std_srvs.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

GraphEnd end(const std::string& topic, const std::string& type, bool writer, std::uint8_t gid = 1) {
  GraphEnd made;
  made.topic = topic;
  made.type = type;
  made.participant = "process";
  made.gid = {gid};
  made.writer = writer;
  return made;
}

constexpr const char* odometry = "nav_msgs::msg::dds_::Odometry_";

TEST(HostPictureTest, ShowsTheTopicsThatAreWrittenAndWhoseTypeIsKnown) {
  const HostPicture sut =
      picture_of({end("rt/odom", odometry, true), end("rt/goal", "x", false),
                  end("rt/other", "no_msgs::msg::dds_::Type_", true), end("plain", odometry, true)},
                 {}, "");
  ASSERT_EQ(sut.topics.size(), 1U);
  EXPECT_EQ(sut.topics[0].name, "/odom");
  EXPECT_STREQ(sut.topics[0].info.qos, "sensor");
  EXPECT_EQ(channel_of(sut.topics[0]).schema.name, "nav_msgs/msg/Odometry");
}

TEST(HostPictureTest, ATopicInTheNamespaceIsTheOneThatALibraryStates) {
  const HostPicture sut =
      picture_of({end("rt/uxv/odom", odometry, true),
                  end("rt/uxv/mission_status", "tocsin_msgs::msg::dds_::MissionStatus_", true),
                  end("rt/odom", odometry, true)},
                 {}, "uxv");
  ASSERT_EQ(sut.topics.size(), 3U);
  EXPECT_STREQ(sut.topics[0].info.name, "/odom");
  EXPECT_STREQ(sut.topics[1].info.name, "mission_status");
  EXPECT_TRUE(sut.topics[1].latched);
  EXPECT_STREQ(sut.topics[2].info.name, "odom");
  EXPECT_FALSE(sut.topics[2].latched);
}

TEST(HostPictureTest, ATopicThatNoLibraryStatesIsReadAsItsWritersOffer) {
  GraphEnd kept = end("rt/map", "std_msgs::msg::dds_::String_", true);
  kept.qos.reliability = Reliability::reliable;
  kept.qos.durability = Durability::transient_local;
  EXPECT_TRUE(picture_of({kept}, {}, "").topics.at(0).latched);
  const GraphEnd other = end("rt/map", "std_msgs::msg::dds_::String_", true, 2);
  EXPECT_FALSE(picture_of({kept, other}, {}, "").topics.at(0).latched);
}

TEST(HostPictureTest, ShowsServicesByTheirServers) {
  const HostPicture sut =
      picture_of({end("rq/dockRequest", "std_srvs::srv::dds_::Trigger_Request_", false),
                  end("rr/dockReply", "std_srvs::srv::dds_::Trigger_Response_", true),
                  end("rq/otherRequest", "std_srvs::srv::dds_::Trigger_Request_", true)},
                 {}, "");
  ASSERT_EQ(sut.services.size(), 1U);
  EXPECT_EQ(sut.services[0].name, "/dock");
  EXPECT_EQ(sut.services[0].type, "std_srvs/srv/Trigger");
  EXPECT_EQ(service_of(sut.services[0]).response.name, "std_srvs/srv/Trigger_Response");
  EXPECT_EQ(service_of(sut.services[0]).response.encoding, "ros2msg");
}

TEST(HostPictureTest, TheGraphNamesNodesAndElseProcesses) {
  GraphNode node{"/", "navigator", {}, {{Gid{1}}}};
  const HostPicture sut =
      picture_of({end("rt/odom", odometry, true, 1), end("rt/odom", odometry, true, 2),
                  end("rt/odom", odometry, false, 3)},
                 {node}, "");
  EXPECT_THAT(sut.graph.publishers,
              ElementsAre(Pair("/odom", ElementsAre("/navigator", "process"))));
  EXPECT_THAT(sut.graph.subscribers, ElementsAre(Pair("/odom", ElementsAre("process"))));
}

TEST(WritableTest, IsWithinTheServersNamespace) {
  EXPECT_EQ(writable_in("", "/goal"), "/goal");
  EXPECT_EQ(writable_in("uxv1", "/goal"), "/uxv1/goal");
  EXPECT_EQ(writable_in("uxv1", "/drive*"), "/uxv1/drive*");
}

}  // namespace
}  // namespace tocsin::foxglove
