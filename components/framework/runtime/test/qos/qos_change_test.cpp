// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_change.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refused(const QosProfile& profile, const std::string& settings) {
  try {
    (void)changed(profile, settings);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(QosChange, ThesePoliciesCanChange) {
  EXPECT_THAT(changeable_policies(),
              ElementsAre("deadline_s", "partition", "lifespan_s", "ownership_strength",
                          "max_rate_hz", "minimum_separation_s"));
}

TEST(QosChange, ReplacesWhatIsNamedAndKeepsTheRest) {
  QosProfile before;
  before.depth = 7;
  before.deadline_s = 1;
  const QosProfile after = changed(before, "{deadline_s: 0.5, partition: [a, b]}");
  EXPECT_EQ(after.deadline_s, 0.5);
  EXPECT_THAT(after.partition, ElementsAre("a", "b"));
  EXPECT_EQ(after.depth, 7);
  EXPECT_TRUE(std::isinf(changed(before, "deadline_s: .inf").deadline_s));
}

TEST(QosChange, RefusesWhatDdsFixesWithTheReasonAndWhatCanChange) {
  EXPECT_THAT(refused({}, "reliability: best_effort"),
              AllOf(HasSubstr("reliability: cannot change while the system runs: DDS fixes it"),
                    HasSubstr("what can change: deadline_s, partition")));
}

TEST(QosChange, RefusesWhatFastDdsWouldIgnore) {
  EXPECT_THAT(refused({}, "heartbeat_period_s: 0.1"), HasSubstr("goes on with the old one"));
  EXPECT_THAT(refused({}, "latency_budget: 0.1"), HasSubstr("announces it and does nothing"));
}

TEST(QosChange, RefusesUnknownWordsAndValuesOutOfRange) {
  EXPECT_THAT(refused({}, "dedline_s: 1"), HasSubstr("did you mean 'deadline_s'"));
  EXPECT_THAT(refused({}, "deadline_s: 0"), HasSubstr("deadline_s: 0 is outside"));
  EXPECT_THAT(refused({}, "deadline_s: soon"), HasSubstr("deadline_s"));
  EXPECT_THAT(refused({}, ""), HasSubstr("nothing to change"));
  EXPECT_THAT(refused({}, "[a]"), HasSubstr("nothing to change"));
}

TEST(QosChange, WhatNoProfileCouldTakeIsRefusedWithoutOne) {
  EXPECT_THROW(check_change("dedline_s: 1"), ConfigError);
  EXPECT_THROW(check_change("reliability: best_effort"), ConfigError);
  EXPECT_THROW(check_change("deadline_s: 0"), ConfigError);
  EXPECT_NO_THROW(check_change("ownership_strength: 3")) << "a profile may have owners";
}

TEST(QosChange, RefusesWhatContradictsTheRestOfTheProfile) {
  EXPECT_THAT(refused({}, "ownership_strength: 3"), HasSubstr("ownership: exclusive"));
  QosProfile slow;
  slow.minimum_separation_s = 1;
  EXPECT_THAT(refused(slow, "deadline_s: 0.5"), HasSubstr("longer than deadline_s"));
}

/// A policy that is fixed by name must be one of a profile, or the table has a typing error.
TEST(QosChange, EveryReasonBelongsToAPolicyOfAProfile) {
  for (const char* policy : {"reliability", "durability", "history", "depth", "publish_mode",
                             "heartbeat_period_s", "user_data"}) {
    EXPECT_NE(why_fixed(policy), "") << policy;
  }
  for (const std::string& policy : changeable_policies()) EXPECT_EQ(why_fixed(policy), "");
}

}  // namespace
}  // namespace tocsin
