// SPDX-License-Identifier: Apache-2.0
// The lists `log` and `keep` of a traffic file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "qos/config_file.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

TEST(TrafficRules, ALoggedTopicMayBeInNoClassAndThenItDoesNotCrossLive) {
  const ConfigFile file("uxv:\n  low: {while_poor: drop, topics: [camera], log: [camera, odom]}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_TRUE(sut.of("camera").logged);
  EXPECT_TRUE(sut.of("camera").live);
  EXPECT_FALSE(sut.of("camera").stored);
  EXPECT_TRUE(sut.of("odom").logged);
  EXPECT_FALSE(sut.of("odom").live);
  EXPECT_EQ(sut.of("odom").traffic_class, TrafficClass::low);
}

TEST(TrafficRules, ALoggedTopicThatAPatternFitsGoesOnCrossingByIt) {
  const ConfigFile file(
      "uxv:\n  high: {while_poor: latest, topics: ['arm/*']}\n  low: {log: [arm/joints, "
      "'raw/*']}\n");
  const TrafficRules sut(file.path(), Role::uxv);
  EXPECT_TRUE(sut.of("arm/joints").logged);
  EXPECT_TRUE(sut.of("arm/joints").live);
  EXPECT_EQ(sut.of("arm/joints").traffic_class, TrafficClass::high);
  EXPECT_FALSE(sut.of("arm/tool").logged);
  EXPECT_TRUE(sut.of("raw/scan").logged);
  EXPECT_FALSE(sut.of("raw/scan").live);
}

TEST(TrafficRules, ATopicIsStoredOrLogged) {
  const ConfigFile file("uxv:\n  low: {topics: [camera], store: [camera], log: [camera]}\n");
  EXPECT_THAT(error_of([&] { TrafficRules(file.path(), Role::uxv); }),
              HasSubstr("uxv.low.log: camera is stored"));
}

TEST(TrafficRules, WhatOneSideWritesTheOtherKeeps) {
  const ConfigFile file(
      "uxv:\n  low: {topics: [battery, camera], log: [odom], keep: [battery, odom, 'arm/*']}\n"
      "gcs:\n  high: {topics: [goal, battery]}\n");
  const TrafficRules station(file.path(), Role::gcs);
  EXPECT_TRUE(station.keeps_any());
  EXPECT_TRUE(station.keeps("battery"));
  EXPECT_TRUE(station.keeps("odom")) << "what of it is fetched";
  EXPECT_TRUE(station.keeps("arm/joints"));
  EXPECT_FALSE(station.keeps("camera"));
  const TrafficRules vehicle(file.path(), Role::uxv);
  EXPECT_FALSE(vehicle.keeps_any());
  EXPECT_FALSE(vehicle.keeps("battery")) << "the station writes one, too, and nobody keeps that";
}

TEST(TrafficRules, AKeptTopicIsOneOfItsClass) {
  const ConfigFile file("uxv:\n  low: {topics: [battery], keep: [batery]}\n");
  const auto error = error_of([&] { TrafficRules(file.path(), Role::uxv); });
  EXPECT_THAT(error,
              HasSubstr("uxv.low.keep: batery is neither in topics nor in log of its class"));
  EXPECT_THAT(error, HasSubstr("battery"));
}

}  // namespace
}  // namespace tocsin
