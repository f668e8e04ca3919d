// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/link_permissions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "qos/config_file.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::Not;
using ::testing::UnorderedElementsAreArray;

const std::string shipped = std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml";

TEST(LinkPermissions, OnlyTheStationWritesGoalsAndDrives) {
  const auto vehicle = link_permissions({Role::uxv, shipped});
  const auto station = link_permissions({Role::gcs, shipped});
  for (const char* topic : {"rt/goal", "rt/teleop/request", "rt/mission_status"}) {
    EXPECT_THAT(station.publish, Contains(topic));
    EXPECT_THAT(vehicle.publish, Not(Contains(topic)));
    EXPECT_THAT(vehicle.subscribe, Contains(topic));
  }
}

TEST(LinkPermissions, NobodyWritesTheStopWhichHasAWayOfItsOwn) {
  for (const Role role : roles) {
    const auto sut = link_permissions({role, shipped});
    EXPECT_THAT(sut.publish, Not(Contains("rt/emergency_stop")));
    EXPECT_THAT(sut.subscribe, Not(Contains("rt/emergency_stop")));
  }
}

TEST(LinkPermissions, OnlyTheVehicleWritesItsState) {
  const auto vehicle = link_permissions({Role::uxv, shipped});
  const auto station = link_permissions({Role::gcs, shipped});
  for (const char* topic : {"rt/location", "rt/camera/image_raw/compressed", "rt/safety_status"}) {
    EXPECT_THAT(vehicle.publish, Contains(topic));
    EXPECT_THAT(station.publish, Not(Contains(topic)));
  }
}

TEST(LinkPermissions, WhatOneSendsTheOtherHears) {
  const auto vehicle = link_permissions({Role::uxv, shipped});
  const auto station = link_permissions({Role::gcs, shipped});
  EXPECT_THAT(vehicle.subscribe, UnorderedElementsAreArray(station.publish));
  EXPECT_THAT(station.subscribe, UnorderedElementsAreArray(vehicle.publish));
  EXPECT_THAT(vehicle.publish, Contains("rt/link_acknowledgement"));
  EXPECT_THAT(vehicle.publish, Contains("rt/link_backfill"));
}

TEST(LinkPermissions, CallsGoBothWaysWhereTheFileNamesServices) {
  for (const Role role : roles) {
    const auto sut = link_permissions({role, shipped});
    for (const char* topic :
         {"rt/link_services", "rt/link_calls_uxv_high", "rt/link_results_uxv_high"}) {
      EXPECT_THAT(sut.publish, Contains(topic));
      EXPECT_THAT(sut.subscribe, Contains(topic));
    }
  }
  const ConfigFile file("uxv: {high: {topics: ['arm/*']}}\ngcs: {}\n");
  const auto without = link_permissions({Role::uxv, file.path()});
  EXPECT_THAT(without.publish, Not(Contains("rt/link_services")));
  EXPECT_THAT(without.publish, Contains("rt/arm/*"));
}

TEST(LinkPermissions, OfATopicThatIsOnlyLoggedThereAreNone) {
  const TemporaryFolder folder;
  const std::string traffic = folder.write(
      "traffic.yaml", "uxv:\n  low: {topics: [camera], log: [odom]}\ngcs:\n  low: {topics: []}\n");
  const auto vehicle = link_permissions({Role::uxv, traffic});
  EXPECT_THAT(vehicle.publish, Contains("rt/camera"));
  EXPECT_THAT(vehicle.publish, Not(Contains("rt/odom")));
}

TEST(LinkPermissions, NeedATrafficFile) {
  EXPECT_THROW((void)link_permissions({Role::uxv, "/nowhere.yaml"}), ConfigError);
}

}  // namespace
}  // namespace tocsin
