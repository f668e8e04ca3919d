// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it: on the shipped files, and beside a running container.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
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

TEST(QosProgram, TheShippedConfigurationIsInNoKnownTrap) {
  const Ended lint = qos({"lint"});
  EXPECT_EQ(lint.output, "no known trap\n");
  EXPECT_EQ(lint.code, 0);
}

TEST(QosProgram, WithoutARouterTheSameProfilesAreInSomeAndTheExitCodeSaysSo) {
  const Ended lint = qos({"lint", "--direct"});
  EXPECT_THAT(lint.output, HasSubstr("foreign-clocks: topic goal (command): lifespan of 5 s"));
  EXPECT_EQ(lint.code, 1);
}

TEST(QosProgram, PagesOfTheShippedProfiles) {
  EXPECT_THAT(qos({"list"}).output, HasSubstr("command: {lifespan_s: 5}\n  cmd_vel"));
  EXPECT_THAT(qos({"explain", "state"}).output,
              HasSubstr("durability transient_local: transient_local gives a late reader"));
  EXPECT_THAT(qos({"diff", "sensor", "stream"}).output, HasSubstr("lifespan_s: .inf -> 1"));
  EXPECT_THAT(qos({"show", "event", "--json"}).output, HasSubstr("\"profile\": \"event\""));
}

TEST(QosProgram, MatchesProfilesAndSaysNoByItsExitCode) {
  const Ended yes = qos({"match", "state", "event"});
  EXPECT_THAT(yes.output, HasSubstr("match\n"));
  EXPECT_EQ(yes.code, 0);
  const Ended no = qos({"match", "event", "state"});
  EXPECT_THAT(no.output, HasSubstr("stopped by durability"));
  EXPECT_EQ(no.code, 1);
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

TEST(QosProgram, ThresholdsOfALintAreTheUsers) {
  EXPECT_THAT(qos({"lint", "--mtu", "576"}).output, HasSubstr("large-fragments: link_router"));
  EXPECT_THAT(qos({"lint", "--outage", "600"}).output, HasSubstr("short-lease: link_router"));
  EXPECT_EQ(qos({"lint", "--direct", "--synchronised-clocks"}).output, "no known trap\n");
  const std::string path = ::testing::TempDir() + "qos_program_lint.yaml";
  std::ofstream(path) << "extends: qos.yaml\ntelemetry: {liveliness_lease_s: 8}\n";
  EXPECT_THAT(qos({"lint", "--file", path, "--direct", "--synchronised-clocks"}).output,
              HasSubstr("short-lease: topic location (telemetry): liveliness lease of 8 s"));
  EXPECT_EQ(
      qos({"lint", "--file", path, "--direct", "--synchronised-clocks", "--outage", "5"}).code, 0);
}

TEST(QosProgram, StreamsOfALintAreProfilesOfItsFile) {
  const std::string path = ::testing::TempDir() + "qos_program_streams.yaml";
  std::ofstream(path) << "extends: qos.yaml\npictures: {reliability: reliable}\n";
  EXPECT_THAT(qos({"lint", "--file", path, "--stream", "pictures"}).output,
              HasSubstr("reliable-stream: topic of profile pictures (pictures)"));
  const Ended unknown = qos({"lint", "--file", path, "--stream", "pictrues"});
  EXPECT_THAT(unknown.output, HasSubstr("did you mean 'pictures'?"));
  EXPECT_EQ(unknown.code, 2);
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
