// SPDX-License-Identifier: Apache-2.0
// What others rely on: ROS 2's tools on names and types, the radio on sizes, the shipped files on
// names.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "idl_support/encode.hpp"
#include "idl_support/type_registry.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

template <class... Topics>
std::map<std::string, Scope> scopes_of(topic::List<Topics...>) {
  return {{Topics::info.name, Topics::info.scope}...};
}

TEST(TopicLists, HoldWhatCrossesTheLinkAndWhatDoesNot) {
  for (const auto& [name, scope] : scopes_of(topic::AllLinkTopics{})) {
    EXPECT_EQ(scope, Scope::link) << name;
  }
  for (const auto& [name, scope] : scopes_of(topic::AllHostTopics{})) {
    EXPECT_EQ(scope, Scope::host) << name;
  }
}

template <class Topic>
void expect_topic(const std::string& name, const std::string& type) {
  EXPECT_EQ(Topic::info.name, name);
  EXPECT_EQ(type_info<typename Topic::Message>().name, type) << name;
}

/// By these names and types rviz, nav2, robot_localization and image_transport find a vehicle.
TEST(TopicLists, WhatRos2sToolsLookForHasItsNameAndType) {
  expect_topic<topic::CmdVel>("cmd_vel", "geometry_msgs::msg::dds_::Twist_");
  expect_topic<topic::Odom>("odom", "nav_msgs::msg::dds_::Odometry_");
  expect_topic<topic::JointStates>("joint_states", "sensor_msgs::msg::dds_::JointState_");
  expect_topic<topic::Tf>("tf", "tf2_msgs::msg::dds_::TFMessage_");
  expect_topic<topic::TfStatic>("tf_static", "tf2_msgs::msg::dds_::TFMessage_");
  expect_topic<topic::Scan>("scan", "sensor_msgs::msg::dds_::LaserScan_");
  expect_topic<topic::AmclPose>("amcl_pose",
                                "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_");
  expect_topic<topic::InitialPose>("initialpose",
                                   "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_");
  expect_topic<topic::ParticleCloud>("particle_cloud", "nav2_msgs::msg::dds_::ParticleCloud_");
  expect_topic<topic::Plan>("plan", "nav_msgs::msg::dds_::Path_");
  expect_topic<topic::CollisionMonitorState>("collision_monitor_state",
                                             "nav2_msgs::msg::dds_::CollisionMonitorState_");
  expect_topic<topic::MapUpdates>("map_updates", "map_msgs::msg::dds_::OccupancyGridUpdate_");
  expect_topic<topic::Diagnostics>("diagnostics", "diagnostic_msgs::msg::dds_::DiagnosticArray_");
  expect_topic<topic::BatteryState>("battery_state", "sensor_msgs::msg::dds_::BatteryState_");
  expect_topic<topic::Map>("map", "nav_msgs::msg::dds_::OccupancyGrid_");
  expect_topic<topic::CameraImage>("camera/image_raw/compressed",
                                   "sensor_msgs::msg::dds_::CompressedImage_");
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(TOCSIN_REPOSITORY "/config/" + path).rdbuf();
  return text.str();
}

/// A rule for a topic that was renamed would leave the new name without one.
/// On demand topics of the host cross, too.
/// "package::msg::dds_::Name_" of each structure that our files define.
std::set<std::string> defined_types() {
  std::set<std::string> names;
  for (const char* file : {"tocsin_msgs.idl", "link_calls.idl"}) {
    std::ifstream lines(std::string(TOCSIN_REPOSITORY "/idl/tocsin_idl/idl/") + file);
    std::string space = "msg";
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_search(line, found, std::regex(R"(module (msg|srv) \{)"))) space = found[1];
      if (!std::regex_search(line, found, std::regex(R"(struct (\w+) \{)"))) continue;
      names.insert("tocsin_msgs::" + space + "::dds_::" + found[1].str() + "_");
    }
  }
  return names;
}

/// A vehicle and a station of one series of releases understand each other: what crosses the link
/// does not change in it. A new type gets a line; a line changes with the minor version only.
TEST(ReleasedTypes, AreAsReleased) {
  std::set<std::string> released;
  std::ifstream lines(TOCSIN_REPOSITORY "/idl/tocsin_idl/released_types.txt");
  for (std::string name, hash; lines >> name >> hash;) {
    const TypeInfo* const type = find_type(name);
    ASSERT_NE(type, nullptr) << name;
    EXPECT_EQ(type->ros_hash, hash) << name << " has changed: a change needs a type of its own";
    released.insert(name);
  }
  EXPECT_EQ(released, defined_types());
}

TEST(TrafficFiles, NameTopicsThatCrossTheLinkAndNoOthers) {
  const auto link = scopes_of(topic::AllLinkTopics{});
  const auto host = scopes_of(topic::AllHostTopics{});
  for (const char* file : {"traffic.yaml", "traffic_thesis.yaml", "traffic_store.yaml"}) {
    const std::string rules = std::regex_replace(text_of(file), std::regex("#.*"), "");
    ASSERT_FALSE(rules.empty()) << file;
    std::smatch on_demand;
    std::regex_search(rules, on_demand, std::regex(R"(on_demand: \[[^\]]*\])"));
    const std::string asked = on_demand.empty() ? "" : on_demand.str();
    const std::regex lists(R"((topics|adaptive|store): \[([^\]]*)\])");
    for (std::sregex_iterator list(rules.begin(), rules.end(), lists), end; list != end; ++list) {
      std::istringstream words((*list)[2]);
      for (std::string word; std::getline(words >> std::ws, word, ',');) {
        const bool is_asked_for = asked.find(word) != std::string::npos && host.count(word) == 1;
        EXPECT_TRUE(link.count(word) == 1 || is_asked_for) << file << ": " << word;
      }
    }
  }
}

TEST(TrafficFiles, LogTopicsThatThereAre) {
  auto known = scopes_of(topic::AllLinkTopics{});
  known.merge(scopes_of(topic::AllHostTopics{}));
  const std::string rules = std::regex_replace(text_of("traffic_log.yaml"), std::regex("#.*"), "");
  std::smatch list;
  ASSERT_TRUE(std::regex_search(rules, list, std::regex(R"(log: \[([^\]]*)\])")));
  std::istringstream words(list[1]);
  for (std::string word; std::getline(words >> std::ws, word, ',');) {
    EXPECT_EQ(known.count(word), 1U) << word;
  }
}

/// An order that waited out an outage must not move the vehicle: profile command has a lifespan and
/// keeps the newest only.
TEST(TopicLists, WhatMovesTheVehicleIsNeverDeliveredLate) {
  for (const TopicInfo& one :
       {topic::CmdVel::info, topic::CmdVelNavigation::info, topic::CmdVelDocking::info,
        topic::CmdVelTeleop::info, topic::CmdVelSelected::info, topic::CmdVelSmoothed::info,
        topic::TeleopCmdVel::info, topic::Goal::info, topic::DockingCommand::info}) {
    EXPECT_STREQ(one.qos, "command") << one.name;
  }
  const std::regex command(R"(\ncommand: \{[^}]*depth: 1, lifespan_s: [1-9])");
  EXPECT_TRUE(std::regex_search(text_of("qos.yaml"), command));
}

/// RTPS messages on the radio have at most 1400 bytes; header, addressing and origin take 100.
constexpr std::size_t one_packet = 1300;

template <class Message>
std::size_t size_of(const Message& message) {
  return encode(type_info<Message>(), &message).size();
}

TEST(Sizes, AGoalWithAllThatItMayTellCrossesInOnePacket) {
  topic::Goal::Message goal;
  const std::size_t alone = size_of(goal);
  goal.ahead().resize(32);
  EXPECT_EQ(size_of(goal), alone + 32 * 32);
  EXPECT_LT(size_of(goal), one_packet);
}

TEST(Sizes, ADecisionAndAnEmergencyStopCrossInOnePacket) {
  topic::TransmissionState::Message decision;
  decision.role("uxv");
  decision.policy("tocp_reverse");
  decision.reason("forced_resume_samples");
  EXPECT_LT(size_of(decision), 200U);
  topic::SafetyStatus::Message stopped;
  stopped.stopped_by().assign(16, std::string(60, 'x'));  // sixteen people with long names
  EXPECT_LT(size_of(stopped), one_packet);
}

/// Written out by hand from the CDR rules, as another implementation writes it.
TEST(Wire, AnEmergencyStopOfAnyToolIsFiveBytes) {
  topic::EmergencyStop::Message stop;
  stop.data(true);
  EXPECT_EQ(encode(type_info<topic::EmergencyStop::Message>(), &stop),
            (std::vector<std::uint8_t>{0, 1, 0, 0, 1}));
}

TEST(Wire, AHeartbeatIsStampRoleAndCount) {
  topic::Heartbeat::Message beat;
  beat.stamp().sec(1);
  beat.stamp().nanosec(2);
  beat.role("gcs");
  beat.count(0x0304);
  EXPECT_EQ(encode(type_info<topic::Heartbeat::Message>(), &beat),
            (std::vector<std::uint8_t>{0, 1, 0, 0, 1,   0,   0,   0, 2, 0, 0, 0,
                                       4, 0, 0, 0, 'g', 'c', 's', 0, 4, 3, 0, 0}));
}

}  // namespace
}  // namespace tocsin
