// SPDX-License-Identifier: Apache-2.0
// The lists `log` of a traffic file.
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

}  // namespace
}  // namespace tocsin
