// SPDX-License-Identifier: Apache-2.0
// What a role takes from the link, and what never crosses it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "qos/config_file.hpp"
#include "qos/vehicle_chain.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string config = std::string(TOCSIN_REPOSITORY) + "/config";

std::string error_of_chain(const std::string& text) {
  const ConfigFile file(text);
  return error_of([&] { TrafficRules(file.path(), Role::uxv, VehicleChain::ours); });
}

TEST(LinkTakes, ARoleTakesWhatTheOtherSendsAndNothingElse) {
  const ConfigFile file(
      "uxv: {high: {topics: [location, 'arm/*'], log: [odom], store: [location]}}\n"
      "gcs: {high: {topics: [goal], actions: [walk]}}\n");
  const TrafficRules vehicle(file.path(), Role::uxv);
  EXPECT_TRUE(vehicle.takes("goal"));
  EXPECT_TRUE(vehicle.takes("walk/_action/feedback"));
  EXPECT_FALSE(vehicle.takes("location"));  // its own
  EXPECT_FALSE(vehicle.takes("anything"));
  const TrafficRules station(file.path(), Role::gcs);
  EXPECT_TRUE(station.takes("location"));
  EXPECT_TRUE(station.takes("arm/joints"));
  EXPECT_FALSE(station.takes("goal"));
  EXPECT_FALSE(station.takes("odom"));  // it is logged only
}

TEST(LinkTakes, WhatTheOtherStoresOrLogsMayComeLater) {
  const ConfigFile file(
      "uxv: {high: {topics: [location, battery], store: [location], log: [odom]}}\ngcs: {}\n");
  const TrafficRules station(file.path(), Role::gcs);
  EXPECT_TRUE(station.takes_later("location"));
  EXPECT_TRUE(station.takes_later("odom"));
  EXPECT_FALSE(station.takes_later("battery"));
  EXPECT_FALSE(TrafficRules(file.path(), Role::uxv).takes_later("odom"));
}

TEST(LinkTakes, WhatStaysWithTheSenderIsNotTakenByAPattern) {
  const ConfigFile file("uxv: {low: {topics: ['*']}, stays: [rosout]}\ngcs: {}\n");
  const TrafficRules station(file.path(), Role::gcs);
  EXPECT_TRUE(station.takes("scan"));
  EXPECT_FALSE(station.takes("rosout"));
}

TEST(LinkTakes, WithoutAFileEverythingButTheChain) {
  const TrafficRules sut;
  EXPECT_TRUE(sut.takes("anything"));
  EXPECT_TRUE(sut.takes_later("anything"));
  for (const char* const topic : chain_topics) EXPECT_FALSE(sut.takes(topic)) << topic;
}

TEST(LinkTakes, TheChainIsEveryTopicThatMovesOrStopsTheVehicle) {
  for (const TopicInfo& one :
       {topic::CmdVel::info, topic::CmdVelNavigation::info, topic::CmdVelDocking::info,
        topic::CmdVelTeleop::info, topic::CmdVelSelected::info, topic::CmdVelSmoothed::info,
        topic::MuxSetInputs::info, topic::SafetyEnable::info, topic::EmergencyStopRequest::info}) {
    EXPECT_TRUE(is_of_chain(one.name)) << one.name;
  }
  EXPECT_TRUE(is_of_chain("cmd_vel/of_a_component_of_ones_own"));
  EXPECT_TRUE(is_of_chain("commands/motor_power"));
  EXPECT_TRUE(is_of_chain("link_stop"));
  EXPECT_TRUE(is_of_chain("emergency_stop"));
  for (const char* const other :
       {"goal", "teleop/cmd_vel", "docking/command", "odom", "cmd_vel_x", "cmd_vel/backfilled"}) {
    EXPECT_FALSE(is_of_chain(other)) << other;
  }
}

TEST(LinkTakes, AFileThatNamesATopicOfTheChainIsRefusedWithItsLine) {
  EXPECT_THAT(error_of_chain("uxv: {}\ngcs:\n  high: {topics: [goal, cmd_vel]}\n"),
              AllOf(HasSubstr("gcs.high.topics: cmd_vel moves or stops"), HasSubstr(".yaml:3"),
                    HasSubstr("goal, teleop/cmd_vel and docking/command do")));
  EXPECT_THAT(error_of_chain("uxv:\n  low: {topics: [cmd_vel/mine]}\n"),
              HasSubstr("uxv.low.topics: cmd_vel/mine moves"));
}

TEST(LinkTakes, SoIsAPatternThatTakesOneUnlessItStays) {
  EXPECT_THAT(error_of_chain("uxv: {low: {topics: ['*']}}\n"),
              AllOf(HasSubstr("* takes cmd_vel, which moves"), HasSubstr("`stays`")));
  EXPECT_THAT(error_of_chain("uxv: {}\ngcs: {low: {topics: ['safety*/*']}}\n"),
              HasSubstr("takes safety_controller/enable"));
  EXPECT_EQ(error_of_chain("uxv: {low: {topics: ['*odom']}}\n"), "no error");
  EXPECT_EQ(
      error_of_chain(
          "uxv: {low: {topics: ['c*']}, stays: ['cmd_vel*', 'commands/*', 'collision_brake/*']}\n"),
      "no error");
}

TEST(LinkTakes, TheLogOfAVelocityMayCrossAndTheVelocityNot) {
  const ConfigFile file(
      "uxv: {low: {topics: ['cmd*'], log: [cmd_vel]}, stays: [cmd_vel, 'cmd_vel/*', "
      "'commands/*']}\n");
  const TrafficRules sut(file.path(), Role::uxv, VehicleChain::ours);
  ASSERT_NE(sut.find("cmd_vel"), nullptr);
  EXPECT_FALSE(sut.of("cmd_vel").live);
  EXPECT_EQ(sut.find("cmd_vel/of_ones_own"), nullptr);
}

TEST(LinkTakes, ARobotThatIsNotOursIsDrivenOverTheLink) {
  const TrafficRules robot(config + "/traffic_gateway.yaml", Role::uxv);
  EXPECT_TRUE(robot.takes("cmd_vel"));
  const TrafficRules station(config + "/traffic_gateway.yaml", Role::gcs);
  EXPECT_NE(station.find("cmd_vel"), nullptr);
  const std::string path = config + "/traffic_gateway.yaml";
  EXPECT_THAT(error_of([&] { TrafficRules(path, Role::uxv, VehicleChain::ours); }),
              HasSubstr("moves or stops this deployment's vehicle"));
}

TEST(LinkTakes, TheShippedFilesOfOurVehicleNameNothingOfTheChain) {
  for (const char* const name : {"traffic", "traffic_log", "traffic_store", "traffic_thesis"}) {
    for (const Role role : roles) {
      const TrafficRules sut(config + "/" + name + ".yaml", role, VehicleChain::ours);
      for (const char* const topic : chain_topics) EXPECT_FALSE(sut.takes(topic)) << topic;
    }
  }
}

}  // namespace
}  // namespace tocsin
