// SPDX-License-Identifier: Apache-2.0
// A fleet manager, a real broker, and a vehicle at the other end of an emulated radio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using nlohmann::json;
using std::chrono::seconds;

class Vda5050Test : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string file =
        files_.write("one.yaml",
                     "extends: vda5050.yaml\nvehicles: {uxv2: ~}\n"
                     "radio: {channel: \"${share}/config/radio/open.yaml\"}\n");
    stack_.emplace(
        std::vector<std::string>{file, "--without", "page", "--without", "uxv1/payload"});
    ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return listens(); })) << stack_->output();
    ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return is_online() && is_ready(); }))
        << heard() << stack_->output();
  }
  /// Hears all topics, once the broker is there.
  bool listens() {
    if (run_to_end("/usr/bin/mosquitto_pub", socket() + " -t ready -m yes").code != 0) return false;
    subscriber_.emplace(
        std::vector<std::string>{"/usr/bin/mosquitto_sub", "--unix", stack_->path("broker.sock"),
                                 "-t", "vda5050/#", "-F", "%t %p"},
        files_.path("heard"));
    return true;
  }
  [[nodiscard]] std::string socket() const { return "--unix " + stack_->path("broker.sock"); }
  [[nodiscard]] std::string heard() const { return files_.read("heard"); }
  /// All messages of a topic so far.
  [[nodiscard]] std::vector<json> all(const std::string& name) const {
    const std::string topic = "vda5050/v3/tocsin/uxv1/" + name + " ";
    std::vector<json> messages;
    std::istringstream lines(heard());
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind(topic, 0) != 0) continue;
      json message = json::parse(line.substr(topic.size()), nullptr, false);
      if (!message.is_discarded()) messages.push_back(std::move(message));  // else half written
    }
    return messages;
  }
  [[nodiscard]] json last(const std::string& name) const {
    const auto messages = all(name);
    return messages.empty() ? json::object() : messages.back();
  }
  [[nodiscard]] std::vector<std::string> connections() const {
    std::vector<std::string> states;
    for (const json& one : all("connection")) states.push_back(one.at("connectionState"));
    return states;
  }
  [[nodiscard]] bool is_online() const {
    const auto states = connections();
    return !states.empty() && states.back() == "ONLINE";
  }
  [[nodiscard]] bool is_ready() const {
    return last("state").value("operatingMode", "") == "AUTOMATIC";
  }
  bool reaches(const std::string& node, seconds limit) const {
    return Stack::eventually(limit, [&] { return last("state").value("lastNodeId", "") == node; });
  }
  void send(const char* name, const json& body) {
    json message = {{"headerId", 0},
                    {"timestamp", "2026-11-29T12:00:00.000Z"},
                    {"version", "3.0.0"},
                    {"manufacturer", "tocsin"},
                    {"serialNumber", "uxv1"}};
    message.update(body);
    const std::string file = files_.write("message.json", message.dump());
    const Ended ended =
        run_to_end("/usr/bin/mosquitto_pub",
                   socket() + " -t vda5050/v3/tocsin/uxv1/" + std::string(name) + " -f " + file);
    ASSERT_EQ(ended.code, 0) << ended.output;
  }
  /// From node `first` on, of which the first `released` ones are the base: a where the vehicle
  /// begins, b and d 1 m from there, c 2.7 m.
  static json order(int first, int nodes, int released) {
    constexpr double x[] = {0, 1, 2.5, 1};
    constexpr double y[] = {0, -0.4, -1, -0.4};
    json made = {{"orderId", "o1"}, {"orderUpdateId", first > 0 ? 1 : 0}};
    for (int i = first; i < first + nodes; ++i) {
      const bool is_base = i < first + released;
      made["nodes"].push_back({{"nodeId", name(i)},
                               {"sequenceId", 2 * i},
                               {"released", is_base},
                               {"nodePosition", {{"x", x[i]}, {"y", y[i]}, {"mapId", "map"}}},
                               {"actions", json::array()}});
      if (i == first) continue;
      made["edges"].push_back({{"edgeId", name(i - 1) + name(i)},
                               {"sequenceId", 2 * i - 1},
                               {"released", is_base},
                               {"actions", json::array()}});
    }
    return made;
  }
  static std::string name(int node) { return std::string(1, static_cast<char>('a' + node)); }

  const TemporaryFolder files_;
  std::optional<Stack> stack_;
  std::optional<OperatorProcess> subscriber_;
};

TEST_F(Vda5050Test, AnOrderAndItsUpdateAreDrivenThroughASilentRadio) {
  send("order", order(0, 4, 3));
  ASSERT_TRUE(reaches("b", seconds(60))) << last("state");
  stack_->control("uxv1/radio.sock", "set outage 15");
  ASSERT_TRUE(Stack::eventually(seconds(10), [&] { return !is_online(); }));
  EXPECT_EQ(connections().back(), "CONNECTION_BROKEN");
  send("order", order(2, 2, 2));
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return is_online(); }));
  ASSERT_TRUE(reaches("d", seconds(60))) << last("state") << stack_->output();
  EXPECT_EQ(last("state")["orderUpdateId"], 1);
  EXPECT_TRUE(last("state")["nodeStates"].empty());
  EXPECT_TRUE(last("state")["errors"].empty());
}

TEST_F(Vda5050Test, ABrokerAndAGatewayThatAreKilledComeBackAndTheOrderGoesOn) {
  send("order", order(0, 4, 4));
  ASSERT_TRUE(reaches("b", seconds(60))) << last("state");
  ASSERT_EQ(::kill(stack_->running("gcs/broker"), SIGKILL), 0);
  ASSERT_TRUE(reaches("c", seconds(60))) << last("state") << stack_->output();
  const std::size_t before = connections().size();
  ASSERT_EQ(::kill(stack_->running("gcs/uxv1_fleet_control"), SIGKILL), 0);
  ASSERT_TRUE(Stack::eventually(seconds(20), [&] {
    return connections().size() >= before + 2 && is_online();
  })) << heard();
  EXPECT_EQ(connections().at(before), "CONNECTION_BROKEN") << "the last will";
  ASSERT_TRUE(reaches("d", seconds(60))) << last("state") << stack_->output();
  EXPECT_EQ(last("state")["operatingMode"], "AUTOMATIC");
  EXPECT_TRUE(last("state")["errors"].empty());
}

TEST_F(Vda5050Test, ACanceledOrderStandsAndAnotherOneBeginsThere) {
  send("order", order(0, 3, 3));
  ASSERT_TRUE(
      Stack::eventually(seconds(60), [&] { return last("state").value("driving", false); }));
  json cancel = {{"actionType", "cancelOrder"}, {"actionId", "x1"}, {"blockingType", "NONE"}};
  send("instantActions", {{"actions", json::array({cancel})}});
  ASSERT_TRUE(Stack::eventually(seconds(20), [&] {
    const json states = last("state").value("instantActionStates", json::array());
    return !states.empty() && states[0]["actionStatus"] == "FINISHED";
  })) << last("state");
  EXPECT_TRUE(last("state")["nodeStates"].empty());
  json next = order(0, 2, 2);
  next["orderId"] = "o2";
  for (const char* axis : {"x", "y"}) {
    next["nodes"][0]["nodePosition"][axis] = last("visualization")["mobileRobotPosition"][axis];
  }
  send("order", next);
  ASSERT_TRUE(reaches("b", seconds(60))) << last("state");
}

}  // namespace
}  // namespace tocsin
