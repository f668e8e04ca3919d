// SPDX-License-Identifier: Apache-2.0
#include "live_change.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<End> writers_with_deadline(double s) {
  QosContract qos;
  qos.deadline_s = s;
  return {{"w", "T", qos}};
}

TEST(SettingsMap, IsYamlOfPoliciesAndValues) {
  EXPECT_EQ(settings_map({"deadline_s=0.5", "partition=[a, b]", "lifespan_s=inf"}),
            "deadline_s: 0.5\npartition: [a, b]\nlifespan_s: .inf\n");
  EXPECT_THROW((void)settings_map({"deadline_s"}), ConfigError);
  EXPECT_THROW((void)settings_map({"=1"}), ConfigError);
}

TEST(OrderOfAChange, AShorterDeadlineIsOfferedFirstALongerOneRequestedFirst) {
  EXPECT_THAT(order_of(writers_with_deadline(1), "deadline_s: 0.5"),
              ElementsAre("writers", "readers"));
  EXPECT_THAT(order_of(writers_with_deadline(1), "deadline_s: 1"),
              ElementsAre("writers", "readers"));
  EXPECT_THAT(order_of(writers_with_deadline(1), "deadline_s: 2"),
              ElementsAre("readers", "writers"));
  EXPECT_THAT(order_of({}, "deadline_s: 2"), ElementsAre("writers", "readers"));
}

TEST(OrderOfAChange, WhatCannotChangeIsRefusedBeforeAnybodyIsTold) {
  EXPECT_THROW((void)order_of(writers_with_deadline(1), "durability: volatile"), ConfigError);
  EXPECT_THROW((void)order_of(writers_with_deadline(1), "ownership_strength: 4"), ConfigError)
      << "the topic is shared";
}

TEST(Stopped, ArePairsThatDoNotMatch) {
  const auto pairs = pairs_of(writers_with_deadline(2), writers_with_deadline(1));
  EXPECT_EQ(stopped(pairs).size(), 1U);
  EXPECT_TRUE(stopped(pairs_of(writers_with_deadline(1), writers_with_deadline(2))).empty());
}

}  // namespace
}  // namespace tocsin::qos_tool
