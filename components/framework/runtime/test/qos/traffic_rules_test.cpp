// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "qos/config_file.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string config = std::string(TOCSIN_REPOSITORY) + "/config";

TEST(TrafficRules, ShippedFilePausesTheCameraAndNoGoal) {
  const TrafficRules uxv(config + "/traffic.yaml", Role::uxv);
  EXPECT_EQ(uxv.of(topic::CameraImage::info.name).while_poor, WhilePoor::drop);
  EXPECT_EQ(uxv.of(topic::Location::info.name).while_poor, WhilePoor::send);
  const TrafficRules gcs(config + "/traffic.yaml", Role::gcs);
  EXPECT_EQ(gcs.of(topic::Goal::info.name).while_poor, WhilePoor::send);
  EXPECT_EQ(gcs.of(topic::MissionStatus::info.name).while_poor, WhilePoor::send);
}

TEST(TrafficRules, ShippedFileOfTheThesisKeepsTheNewestGoal) {
  const TrafficRules gcs(config + "/traffic_thesis.yaml", Role::gcs);
  EXPECT_EQ(gcs.of(topic::Goal::info.name).while_poor, WhilePoor::latest);
}

TEST(TrafficRules, ShippedFileOfTheThesisIsTheOtherButForTheClassOfGoals) {
  for (const Role role : roles) {
    const TrafficRules shipped(config + "/traffic.yaml", role);
    const TrafficRules thesis(config + "/traffic_thesis.yaml", role);
    EXPECT_EQ(thesis.all().size(), shipped.all().size());
    for (const auto& [topic, rule] : shipped.all()) {
      EXPECT_EQ(thesis.of(topic).traffic_class, rule.traffic_class) << topic;
      if (role == Role::gcs && rule.traffic_class == TrafficClass::high) continue;
      EXPECT_EQ(thesis.of(topic).while_poor, rule.while_poor) << topic;
    }
  }
}

TEST(TrafficRules, AFileMayExtendAnotherAndMoveATopic) {
  const ConfigFile file("extends: base.yaml\nuxv: {high: {topics: [b]}}\n");
  file.write("base.yaml",
             "uxv:\n  high: {while_poor: send, topics: [a]}\n"
             "  low: {while_poor: drop, topics: [b, c]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.of("b").traffic_class, TrafficClass::high);
  EXPECT_EQ(sut.of("b").while_poor, WhilePoor::send);
  EXPECT_EQ(sut.of("a").while_poor, WhilePoor::send);
  EXPECT_EQ(sut.of("c").while_poor, WhilePoor::drop);
}

TEST(TrafficRules, AnAdaptiveTopicIsNamedBesideItsClass) {
  const ConfigFile file("uxv:\n  low: {topics: [camera, cpu], adaptive: [camera]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_TRUE(sut.of("camera").adaptive);
  EXPECT_FALSE(sut.of("cpu").adaptive);
}

TEST(TrafficRules, ACompressedTopicIsNamedBesideItsClassByItsNameOrAPatternThatFits) {
  const ConfigFile file(
      "uxv:\n  high: {topics: [odom, imu], compress: [odom]}\n"
      "  low: {topics: [cpu, scan, 'map*'], compress: ['*']}\ngcs: {}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_TRUE(sut.of("odom").compressed);
  EXPECT_FALSE(sut.of("imu").compressed);
  EXPECT_TRUE(sut.of("cpu").compressed);
  EXPECT_TRUE(sut.of("map_tiles").compressed);
}

TEST(TrafficRules, ATopicOnDemandIsNamedBesideItsClassByItsNameOrPattern) {
  const ConfigFile file(
      "uxv:\n  low: {topics: [cpu, scan, 'map*'], on_demand: [scan, 'map*']}\ngcs: {}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_TRUE(sut.of("scan").on_demand);
  EXPECT_TRUE(sut.of("map_tiles").on_demand);
  EXPECT_FALSE(sut.of("cpu").on_demand);
  EXPECT_TRUE(sut.waits_for_demand("scan"));
  EXPECT_FALSE(sut.waits_for_demand("cpu"));
  EXPECT_FALSE(sut.waits_for_demand("unknown"));
  const TrafficRules there(file.path(), Role::gcs);
  EXPECT_TRUE(there.takes_on_demand("scan"));
  EXPECT_FALSE(there.takes_on_demand("cpu"));
  EXPECT_FALSE(there.takes_on_demand("unknown"));
  EXPECT_FALSE(sut.takes_on_demand("scan")) << "its own";
}

TEST(TrafficRules, WhatALogOrARuleNeedsDoesNotWaitForDemand) {
  const ConfigFile file(
      "uxv:\n  low: {topics: [scan, imu, tf], on_demand: [scan, imu, tf], log: [scan]}\n"
      "  fetch:\n    - {when: imu, topics: [scan]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_FALSE(sut.waits_for_demand("scan"));
  EXPECT_FALSE(sut.waits_for_demand("imu"));
  EXPECT_TRUE(sut.waits_for_demand("tf"));
}

TEST(TrafficRules, AStoredTopicIsNamedBesideItsClass) {
  const ConfigFile file(
      "uxv:\n  low: {while_poor: drop, topics: [battery, cpu], store: [battery]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_TRUE(sut.of("battery").stored);
  EXPECT_EQ(sut.of("battery").while_poor, WhilePoor::drop);
  EXPECT_FALSE(sut.of("cpu").stored);
}

TEST(TrafficRules, OfAClassThatStoresAllIsStoredAndTheNewestGoesOnResume) {
  const ConfigFile file("uxv:\n  low: {while_poor: store, topics: [battery, cpu]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  for (const char* const topic : {"battery", "cpu"}) {
    EXPECT_TRUE(sut.of(topic).stored);
    EXPECT_EQ(sut.of(topic).while_poor, WhilePoor::latest);
  }
}

TEST(TrafficRules, ATopicThatAFileMovesToAnotherClassMayHaveBeenAdaptive) {
  const ConfigFile file("extends: base.yaml\nuxv: {high: {topics: [camera]}}\n");
  file.write("base.yaml", "uxv:\n  low: {topics: [camera, cpu], adaptive: [camera]}\n");
  EXPECT_EQ(TrafficRules(file.path(), Role::uxv).of("camera").traffic_class, TrafficClass::high);
}

TEST(TrafficRules, ATopicWithoutClassIsAnError) {
  const ConfigFile file("uxv:\n  low: {while_poor: drop, topics: [a]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_THAT(error_of([&] { (void)sut.of("b"); }),
              HasSubstr("topic b: crosses the link, but has no traffic class for role uxv"));
}

TEST(TrafficRules, WithoutAFileNothingIsPaused) {
  const TrafficRules sut;
  EXPECT_EQ(sut.of("b").while_poor, WhilePoor::send);
  EXPECT_EQ(sut.of("b").traffic_class, TrafficClass::normal);
  EXPECT_TRUE(sut.all().empty());
  EXPECT_EQ(sut.dscp(TrafficClass::critical), 48);
  EXPECT_EQ(sut.dscp(TrafficClass::normal), 0);
}

TEST(TrafficRules, ANameGoesBeforeAPatternAndALongerPatternBeforeAShorterOne) {
  const ConfigFile file(
      "uxv:\n  high: {topics: [arm/tool, 'arm/*']}\n  low: {topics: ['*']}\n"
      "  critical: {topics: ['arm/*/stop']}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.of("arm/tool").traffic_class, TrafficClass::high);
  EXPECT_EQ(sut.of("arm/joint/1").traffic_class, TrafficClass::high);
  EXPECT_EQ(sut.of("arm/joint/stop").traffic_class, TrafficClass::critical);
  EXPECT_EQ(sut.of("scan").traffic_class, TrafficClass::low);
  EXPECT_EQ(sut.all().size(), 1U);
  EXPECT_EQ(sut.patterns().size(), 3U);
}

TEST(TrafficRules, WhatStaysIsTakenByNoPatternButByItsName) {
  const ConfigFile file(
      "uxv:\n  low: {topics: ['*', secret/door]}\n  stays: [rosout, 'secret/*']\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.find("rosout"), nullptr);
  EXPECT_EQ(sut.find("secret/key"), nullptr);
  EXPECT_NE(sut.find("secret/door"), nullptr);
  EXPECT_NE(sut.find("scan"), nullptr);
}

TEST(TrafficRules, AClassLimitsRateAgeAndDepthOfItsTopics) {
  const ConfigFile file(
      "uxv:\n  low: {topics: ['*'], max_rate_hz: 5, lifespan_s: 0.5, depth: 10}\n"
      "  high: {topics: [odom]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.of("scan").max_rate_hz, 5);
  EXPECT_EQ(sut.of("scan").lifespan_s, 0.5);
  EXPECT_EQ(sut.of("scan").depth, 10);
  EXPECT_EQ(sut.of("odom").max_rate_hz, 0);
  EXPECT_EQ(sut.of("odom").lifespan_s, std::numeric_limits<double>::infinity());
  EXPECT_EQ(sut.of("odom").depth, 1);
}

TEST(TrafficRules, ServicesAreServedByTheSideThatNamesThemAndCalledByTheOther) {
  const ConfigFile file(
      "uxv:\n  high: {services: [dock, '*/get_parameters'], call_deadline_s: 2}\n"
      "gcs:\n  low: {services: [alarm]}\n");
  const TrafficRules uxv(file.path(), Role::uxv);
  ASSERT_NE(uxv.served("dock"), nullptr);
  EXPECT_EQ(uxv.served("dock")->how.traffic_class, TrafficClass::high);
  EXPECT_EQ(uxv.served("dock")->how.deadline_s, 2);
  EXPECT_FALSE(uxv.served("dock")->on_demand);
  ASSERT_NE(uxv.served("arm/get_parameters"), nullptr);
  EXPECT_TRUE(uxv.served("arm/get_parameters")->on_demand);
  EXPECT_EQ(uxv.called("dock"), nullptr);
  ASSERT_NE(uxv.called("alarm"), nullptr);
  EXPECT_EQ(uxv.called("alarm")->how.deadline_s, 5);
  const TrafficRules gcs(file.path(), Role::gcs);
  EXPECT_NE(gcs.called("dock"), nullptr);
  EXPECT_NE(gcs.served("alarm"), nullptr);
  EXPECT_EQ(gcs.served("dock"), nullptr);
  EXPECT_EQ(gcs.call_classes().size(), 2U);
}

TEST(TrafficRules, AnActionIsItsThreeServicesAndItsTwoTopics) {
  const ConfigFile file("uxv: {high: {actions: [drive]}}\ngcs: {}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  for (const char* service : {"send_goal", "cancel_goal", "get_result"}) {
    EXPECT_NE(sut.served("drive/_action/" + std::string(service)), nullptr) << service;
  }
  EXPECT_EQ(sut.of("drive/_action/feedback").traffic_class, TrafficClass::high);
  EXPECT_EQ(sut.of("drive/_action/status").traffic_class, TrafficClass::high);
  const TrafficRules gcs(file.path(), Role::gcs);
  EXPECT_EQ(gcs.find("drive/_action/feedback"), nullptr);
  EXPECT_NE(gcs.called("drive/_action/send_goal"), nullptr);
}

TEST(TrafficRules, AServiceInTwoClassesIsAnErrorOfEitherSide) {
  const ConfigFile file("uxv:\n  high: {services: [dock]}\n  low: {services: [dock]}\ngcs: {}\n");
  for (const Role role : roles) {
    EXPECT_THAT(error_of([&] { TrafficRules(file.path(), role); }),
                AllOf(HasSubstr("uxv.low.services: dock is in two classes"), HasSubstr(":3)")));
  }
}

TEST(TrafficRules,
     ShippedFilesLetEachSideCallActionsOfTheOtherAndTheStationParametersOfTheVehicle) {
  const TrafficRules mission(config + "/traffic.yaml", Role::gcs);
  EXPECT_NE(mission.called("navigate_to_pose/_action/send_goal"), nullptr);
  EXPECT_NE(mission.called("navigator/set_parameters"), nullptr);
  EXPECT_NE(TrafficRules(config + "/traffic.yaml", Role::uxv)
                .called("follow_waypoints/_action/send_goal"),
            nullptr);
  EXPECT_EQ(mission.called("navigator/change_state"), nullptr);
  const TrafficRules gateway(config + "/traffic_gateway.yaml", Role::gcs);
  EXPECT_NE(gateway.called("anything"), nullptr);
}

TEST(TrafficRules, OfAGatewayInternalsOfTheStackStayOnTheirHost) {
  const TrafficRules sut(config + "/traffic_gateway.yaml", Role::uxv);
  EXPECT_EQ(sut.of("camera/image_raw/compressed").traffic_class, TrafficClass::low);
  EXPECT_EQ(sut.of("robot1/odom").traffic_class, TrafficClass::high);
  for (const char* const topic : {"rosout", "parameter_events", "container_state"}) {
    EXPECT_EQ(sut.find(topic), nullptr) << topic;
  }
}

TEST(TrafficRules, PathsAreOfAClass) {
  const ConfigFile file("uxv: {}\npaths: {critical: both, low: repair}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.paths_of(TrafficClass::critical), PathUse::both);
  EXPECT_EQ(sut.paths_of(TrafficClass::high), PathUse::repair) << "by default";
  EXPECT_EQ(sut.paths_of(TrafficClass::normal), PathUse::best);
  EXPECT_EQ(sut.paths_of(TrafficClass::low), PathUse::repair);
  EXPECT_EQ(TrafficRules().paths_of(TrafficClass::critical), PathUse::repair);
}

TEST(TrafficRules, ClassesHaveTheDefaultDscpUnlessTheFileSaysAnother) {
  const ConfigFile file("uxv: {}\ndscp: {high: 34, low: 0}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.dscp(TrafficClass::critical), 48);
  EXPECT_EQ(sut.dscp(TrafficClass::high), 34);
  EXPECT_EQ(sut.dscp(TrafficClass::normal), 0);
  EXPECT_EQ(sut.dscp(TrafficClass::low), 0);
}

TEST(TrafficRules, AFileThatExtendsAnotherHasItsDscp) {
  const ConfigFile file("extends: base.yaml\ndscp: {high: 40}\n");
  file.write("base.yaml", "uxv: {}\ndscp: {high: 34, low: 0}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_EQ(sut.dscp(TrafficClass::high), 40);
  EXPECT_EQ(sut.dscp(TrafficClass::low), 0);
}

TEST(TrafficRules, AMistakeIsAnErrorWithItsPlace) {
  for (const auto& [text, error, place] : std::vector<std::array<const char*, 3>>{
           {"uxv:\n  hihg: {topics: [a]}\n", "uxv.hihg: is no traffic class; did you mean 'high'?",
            ":2)"},
           {"uxv: {}\ndcsp: {high: 34}\n",
            "'dcsp' is neither a role nor dscp nor paths; did you mean", ":2)"},
           {"uxv: {}\npaths: {high: all}\n", "paths.high: 'all' is not one of: best, repair, both",
            ":2)"},
           {"uxv: {}\ndscp: {high: 64}\n", "dscp.high: 64 is outside [0, 63]", ":2)"},
           {"uxv: {}\ndscp: {urgent: 46}\n", "dscp.urgent: unknown key; allowed: ", ":2)"},
           {"uxv:\n  low: {while_poor: delete}\n", "'delete' is not one of: send, latest, drop",
            ":2)"},
           {"uxv:\n  low: {topics: [a]}\n  high: {topics: [a]}\n", "a is in two classes", ":3)"},
           {"uxv:\n  low: {topics: [camera], adaptive: [camra]}\n",
            "uxv.low.adaptive: camra is in no class of this role", ":2)"},
           {"uxv:\n  low: {topics: [scan], compress: [scam]}\n",
            "uxv.low.compress: scam is in no class of this role", ":2)"},
           {"uxv:\n  low: {topics: [scan]}\n  high: {topics: [odom], compress: ['sc?n', 'x*']}\n",
            "uxv.high.compress: x* is in no class of this role", ":3)"},
           {"uxv:\n  low: {topics: [scan], on_demand: [scam]}\n",
            "uxv.low.on_demand: scam is in no class of this role", ":2)"},
           {"uxv:\n  low: {topics: [scan], on_demand: [scan], store: [scan]}\n",
            "uxv.low.on_demand: scan is stored, so that all of it crosses anyway", ":2)"},
           {"uxv:\n  low: {topics: [battery], store: [batery]}\n",
            "uxv.low.store: batery is in no class of this role", ":2)"},
           {"uxv:\n  low: {topics: ['*']}\n  stays: {a: b}\n", "uxv.stays: is no list of names",
            ":3)"},
           {"gcs: {}\n", "has no map for the role 'uxv'", ""},
           {"extends: base.yaml\nuxv: {high: {topics: [b]}}\n", "while_poor", "base.yaml:3)"}}) {
    const ConfigFile file(text);
    file.write("base.yaml", "uxv:\n  high: {topics: [a]}\n  low: {while_poor: delete}\n");
    EXPECT_THAT(error_of([&] { TrafficRules(file.path(), Role::uxv); }),
                AllOf(HasSubstr(error), HasSubstr(place)))
        << text;
  }
}

}  // namespace
}  // namespace tocsin
