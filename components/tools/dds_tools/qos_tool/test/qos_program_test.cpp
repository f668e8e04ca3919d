// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it, where its page does not play it (test/system).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command_line/run_to_end.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Ended qos(std::vector<std::string> words) {
  words.insert(words.begin(), QOS_PROGRAM);
  return run_to_end(words);
}

TEST(QosProgram, WithoutARouterTheSameProfilesAreInSomeAndTheExitCodeSaysSo) {
  const Ended lint = qos({"lint", "--direct"});
  EXPECT_THAT(lint.output, HasSubstr("foreign-clocks: topic goal (command): lifespan of 5 s"));
  EXPECT_EQ(lint.code, 1);
}

TEST(QosProgram, ExplainsEveryPolicy) {
  EXPECT_THAT(qos({"explain", "state"}).output,
              HasSubstr("durability transient_local: transient_local gives a late reader"));
}

TEST(QosProgram, ExportsForBothVendors) {
  EXPECT_THAT(qos({"export", "command", "--to", "fastdds"}).output,
              AllOf(HasSubstr("fastRTPS_Profiles"), HasSubstr("profile_name=\"command\"")));
  EXPECT_THAT(qos({"export", "command", "--to", "cyclone"}).output,
              AllOf(HasSubstr("omg.org/spec/DDS-XML"), HasSubstr("qos_profile name=\"command\"")));
}

nlohmann::json json_of(std::vector<std::string> words) {
  words.emplace_back("--json");
  return nlohmann::json::parse(qos(words).output);
}

TEST(QosProgram, ScriptsGetJson) {
  const auto list = json_of({"list"});
  ASSERT_FALSE(list.empty());
  EXPECT_EQ(list[0]["profile"], "command");
  EXPECT_EQ(list[0]["policies"]["lifespan_s"]["default"], false);
  EXPECT_EQ(json_of({"diff", "sensor", "stream"})["depth"][1], "1");
  EXPECT_EQ(json_of({"match", "event", "state"})[0]["stopped_by"][0], "durability");
  EXPECT_TRUE(json_of({"lint"}).empty());
  for (const auto& one : json_of({"lint", "--direct"})) EXPECT_EQ(one["rule"], "foreign-clocks");
}

TEST(QosProgram, WhatIsWrongIsRefusedBeforeARunningSystemIsLookedFor) {
  const Ended set = qos({"set", "/odom", "deadlin_s=1", "--domain", "96", "--spin-time", "60"});
  EXPECT_THAT(set.output, HasSubstr("'deadlin_s' is not a policy; did you mean 'deadline_s'?"));
  EXPECT_EQ(set.code, 2);
}

TEST(QosProgram, BadUsageIsOneLineAndExitCodeTwo) {
  EXPECT_EQ(qos({"show", "sensr"}).code, 2);
  EXPECT_EQ(qos({"set", "/odom", "--domain", "96"}).code, 2);
  EXPECT_EQ(qos({"set", "/odom", "deadline_s=1", "--domain", "96", "--spin-time", "0.2"}).code, 1)
      << "nobody is there";
}

}  // namespace
}  // namespace tocsin::qos_tool
