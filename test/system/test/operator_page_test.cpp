// SPDX-License-Identifier: Apache-2.0
// The operator's server in a real mission over the emulated radio: an independent client, the
// Foxglove WebSocket client of the protocol's makers, outside of the station's network. Skipped
// where it was not installed (npm ci in test/foxglove_peer).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::Contains;
using ::testing::HasSubstr;

const std::string peer = std::string(TOCSIN_REPOSITORY) + "/test/foxglove_peer";
constexpr const char* port = "18765";

std::string output_of(const std::string& command) { return run_to_end(command, "").output; }

/// The mission with a talker beside it, whose text can be set, and a port of the test's own.
std::string bringup_in(const TemporaryFolder& folder) {
  return folder.write("page.yaml", std::string("extends: mission.yaml\n"
                                               "hosts:\n"
                                               "  gcs:\n"
                                               "    containers:\n"
                                               "      - name: page\n"
                                               "        components:\n"
                                               "          - component: operator_server\n"
                                               "            parameters: {port: ") +
                                       port +
                                       "}\n"
                                       "      - name: talker\n"
                                       "        components: [talker]\n");
}

const std::string served = std::string("gcs/page serves http://127.0.0.1:") + port + "/";

TEST(OperatorPageTest, ClientsReadPublishSetAndCallFromOutsideOfTheEmulatedNetwork) {
  if (!std::filesystem::exists(peer + "/node_modules/@foxglove/ws-protocol")) {
    GTEST_SKIP() << "@foxglove/ws-protocol is not installed: npm ci in test/foxglove_peer";
  }
  if (output_of("node --version 2>/dev/null").empty()) GTEST_SKIP() << "there is no node";
  const TemporaryFolder folder;
  const Stack stack({bringup_in(folder), "--seed", "1", "--without", "gcs/view"});
  const auto is_there = [&] { return !stack.recorded("gcs", "location").empty(); };
  ASSERT_TRUE(Stack::eventually(seconds(40), is_there)) << stack.output();
  EXPECT_THAT(stack.output(), HasSubstr(served));
  const std::string text = output_of("node " + peer + "/client.mjs " + port + " 3");
  const auto said = nlohmann::json::parse(text, nullptr, false);
  ASSERT_FALSE(said.is_discarded()) << text;
  EXPECT_EQ(said.at("end"), "done") << text;
  EXPECT_EQ(said.at("protocol"), "foxglove.websocket.v1");
  EXPECT_EQ(said.at("server").at("metadata").at("host"), "gcs");
  EXPECT_EQ(said.at("undecoded"), nlohmann::json::array()) << text;
  for (const char* topic : {"/location", "/mission_status", "/network_quality", "/heartbeat",
                            "/transmission_state", "/link_state", "/greetings"}) {
    EXPECT_GT(said.at("topics").value(topic, 0), 0) << topic;
  }
  EXPECT_GT(said.at("times"), 10);
  EXPECT_GT(said.at("graph"), 10);
  EXPECT_EQ(said.at("parameters").value("/talker.text", ""), "told by a page") << text;
  EXPECT_GT(said.at("parameters").size(), 20U) << text;
  EXPECT_THAT(said.at("service").at("result").at("names"), Contains("text")) << text;
  EXPECT_THAT(said.at("page").get<std::string>(), HasSubstr("<!doctype html>"));
  const auto goal_came = [&](const std::string& id) {
    const std::string goals = stack.recorded("gcs", "goal");
    const auto ids = column(goals, "id");
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  EXPECT_TRUE(Stack::eventually(seconds(30), [&] {
    return goal_came("900001") && goal_came("900002");
  })) << text;
}

/// For ten minutes by hand: README of test/foxglove_peer.
TEST(OperatorPageTest, OneOfTwentyClientsThatReadsNothingHoldsUpNobody) {
  if (!std::filesystem::exists(peer + "/node_modules/@foxglove/ws-protocol")) {
    GTEST_SKIP() << "@foxglove/ws-protocol is not installed: npm ci in test/foxglove_peer";
  }
  if (output_of("node --version 2>/dev/null").empty()) GTEST_SKIP() << "there is no node";
  const TemporaryFolder folder;
  const Stack stack({bringup_in(folder), "--without", "gcs/view"});
  const auto is_there = [&] { return !stack.recorded("gcs", "location").empty(); };
  ASSERT_TRUE(Stack::eventually(seconds(60), is_there)) << stack.output();
  const std::string text = output_of("node " + peer + "/crowd.mjs " + port + " 5 --pid " +
                                     std::to_string(stack.pid("gcs/page")));
  std::cout << text;
  const auto said = nlohmann::json::parse(text, nullptr, false);
  ASSERT_FALSE(said.is_discarded()) << text;
  EXPECT_EQ(said.at("ended"), 0) << "of those that read";
  EXPECT_GT(said.at("messages").at("least"), 0);
  EXPECT_GT(said.at("location_ms").at("count"), 0);
  const auto& memory = said.at("memory_mib");
  EXPECT_LT(memory.at("most").get<double>(), memory.at("first").get<double>() + 64);
}

TEST(OperatorPageTest, ASecondRunOnTheSamePortSaysSoAndRuns) {
  const TemporaryFolder folder;
  const std::string file = bringup_in(folder);
  const std::vector<std::string> arguments{file, "--without", "gcs/view", "--without",
                                           "gcs/talker"};
  const Stack first(arguments);
  ASSERT_TRUE(Stack::eventually(seconds(20), [&] {
    return first.output().find(served) != std::string::npos;
  })) << first.output();
  const Stack second(arguments);
  EXPECT_TRUE(Stack::eventually(seconds(40), [&] {
    return !second.recorded("gcs", "location").empty();
  })) << second.output();
  EXPECT_THAT(second.output(), HasSubstr("gcs/page cannot serve http://127.0.0.1:18765/: Address "
                                         "already in use; all else goes on"));
}

}  // namespace
}  // namespace tocsin
