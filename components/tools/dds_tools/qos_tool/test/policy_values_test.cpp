// SPDX-License-Identifier: Apache-2.0
#include "policy_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;

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

TEST(PolicyValues, TheEffectiveProfileSaysWhatTheRuntimeDecides) {
  QosProfile profile;
  profile.depth = 4;
  profile.liveliness_lease_s = 3;
  EXPECT_EQ(effective(profile).max_samples, 5);
  EXPECT_EQ(effective(profile).liveliness_announcement_s, 1);
}

}  // namespace
}  // namespace tocsin::qos_tool
