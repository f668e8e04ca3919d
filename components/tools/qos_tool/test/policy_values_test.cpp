// SPDX-License-Identifier: Apache-2.0
#include "policy_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "meanings.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A profile that differs from the defaults in a value of each type.
QosProfile strange() {
  QosProfile profile;
  profile.reliability = Reliability::best_effort;
  profile.deadline_s = 0.25;
  profile.depth = 7;
  profile.heartbeat_piggyback = false;
  profile.partition = {"a", "b, c", ""};
  profile.user_data = "x=1;";
  return profile;
}

TEST(PolicyValues, TellWhatDiffersFromTheDefaults) {
  std::vector<std::string> different;
  for (const PolicyValue& one : values_of(strange())) {
    if (!one.is_default) different.push_back(one.policy + "=" + one.value);
  }
  EXPECT_THAT(different, ElementsAre("reliability=best_effort", "deadline_s=0.25",
                                     "partition=[a, \"b, c\", \"\"]", "depth=7",
                                     "heartbeat_piggyback=false", "user_data=x=1;"));
}

TEST(PolicyValues, AProfileComesBackFromItsValues) {
  EXPECT_EQ(value_map(profile_of(value_map(strange()), "p")), value_map(strange()));
  EXPECT_TRUE(std::isinf(profile_of({{"deadline_s", ".inf"}}, "p").deadline_s));
}

TEST(PolicyValues, ValuesThatNoQosFileCouldSayAreRefusedByName) {
  const auto refused = [](const Values& values) -> std::string {
    try {
      (void)profile_of(values, "p");
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refused({{"depth", "0"}}), HasSubstr("p.depth: 0 is outside [1, 10000]"));
  EXPECT_THAT(refused({{"durability", "persistent"}}), HasSubstr("p.durability"));
  EXPECT_THAT(refused({{"reliability", "best_effort"}, {"durability", "transient_local"}}),
              HasSubstr("p.durability: transient_local needs reliability"));
}

TEST(PolicyValues, TheEffectiveProfileSaysWhatTheRuntimeDecides) {
  QosProfile profile;
  profile.depth = 4;
  profile.liveliness_lease_s = 3;
  EXPECT_EQ(effective(profile).max_samples, 5);
  EXPECT_EQ(effective(profile).publish_mode, PublishMode::synchronous);
  EXPECT_EQ(effective(profile).liveliness_announcement_s, 1);
  profile.flow_controller = "radio";
  EXPECT_EQ(effective(profile).publish_mode, PublishMode::asynchronous);
}

TEST(Meanings, EveryPolicyOfAProfileHasOne) {
  for (const PolicyValue& one : values_of({})) {
    EXPECT_NE(meaning_of(one.policy, {}), "") << one.policy;
    EXPECT_NE(meaning_of(one.policy, strange()), "") << one.policy;
  }
  EXPECT_EQ(meaning_of("colour", {}), "");
}

TEST(Meanings, FollowTheValue) {
  QosProfile all;
  all.history = History::keep_all;
  all.max_samples = 20;
  EXPECT_EQ(meaning_of("history", all),
            "all samples are kept until they are taken; a reliable writer whose 20 places are full "
            "waits for 0.1 s, then refuses");
  QosProfile late;
  late.durability = Durability::transient_local;
  late.depth = 3;
  EXPECT_EQ(meaning_of("durability", late),
            "a reader that comes later gets the last 3 sample(s) of each writer at once");
  EXPECT_EQ(meaning_of("durability", {}), "a reader that comes later waits for the next sample");
  EXPECT_EQ(meaning_of("priority", {}), "means nothing without a flow controller");
}

}  // namespace
}  // namespace tocsin::qos_tool
