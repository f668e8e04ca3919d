// SPDX-License-Identifier: Apache-2.0
// What leaves, against the standard's own fields, restated here from its JSON schemas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "gateway_fixture.hpp"
#include "vda5050_gateway/messages.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using News = DriveNews::Kind;

constexpr std::int64_t noon_ns = 1796126400'250'000'000;

class MessagesTest : public ::testing::TestWithParam<Version> {
 protected:
  MessagesTest() : rig_(GetParam()), sut_(rig_.texts.identity(), {}) { sut_.on_connected(); }
  [[nodiscard]] bool is_new() const { return GetParam() == Version::v3_0; }
  /// Messages that are due, by the last level of their topics.
  std::map<std::string, json> due() {
    std::map<std::string, json> all;
    for (const Message& message : sut_.due(rig_.sut, rig_.vehicle, rig_.now, noon_ns)) {
      const std::string name = message.topic.substr(message.topic.rfind('/') + 1);
      EXPECT_EQ(all.count(name), 0u) << name << " twice";
      all[name] = json::parse(message.payload);
    }
    return all;
  }
  std::vector<std::string> names_due(double after_s) {
    rig_.step(after_s);
    std::vector<std::string> names;
    for (const auto& [name, message] : due()) names.push_back(name);
    return names;
  }
  static std::set<std::string> keys(const json& message) {
    std::set<std::string> all;
    for (const auto& [key, value] : message.items()) all.insert(key);
    return all;
  }
  GatewayFixture rig_;
  Publications sut_;
};
INSTANTIATE_TEST_SUITE_P(Versions, MessagesTest, ::testing::Values(Version::v2_1, Version::v3_0),
                         [](const auto& one) { return one.param == Version::v2_1 ? "v2" : "v3"; });

TEST_P(MessagesTest, AllIsTellableAtTheStart) {
  const auto all = due();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all.at("connection").at("connectionState"), "ONLINE");
  EXPECT_EQ(all.at("connection").at("headerId"), 0);
  EXPECT_EQ(all.at("connection").at("timestamp"), "2026-12-01T12:00:00.250Z");
  EXPECT_EQ(all.at("connection").at("version"), is_new() ? "3.0.0" : "2.1.0");
  EXPECT_EQ(all.at("factsheet").at("serialNumber"), "uxv1");
}

TEST_P(MessagesTest, TopicsAreThoseOfTheVersion) {
  const std::string topic = sut_.will(noon_ns).topic;
  EXPECT_EQ(topic,
            is_new() ? "vda5050/v3/tocsin/uxv1/connection" : "uagv/v2/tocsin/uxv1/connection");
  EXPECT_TRUE(sut_.will(noon_ns).is_retained);
  EXPECT_EQ(sut_.will(noon_ns).qos, 1);
  EXPECT_EQ(json::parse(sut_.will(noon_ns).payload).at("connectionState"),
            is_new() ? "CONNECTION_BROKEN" : "CONNECTIONBROKEN");
  EXPECT_EQ(json::parse(sut_.farewell(noon_ns).payload).at("connectionState"), "OFFLINE");
}

TEST_P(MessagesTest, AStateHasTheFieldsOfItsVersion) {
  json order = rig_.texts.order(3, 2);
  order["nodes"][1]["actions"].push_back(OrderTexts::action("startCharging", "c1"));
  rig_.order(order);
  rig_.instant("dance");
  rig_.vehicle.voltage_v = 16.2;
  const json state = due().at("state");
  const std::set<std::string> common = {
      "headerId",   "timestamp",     "version",     "manufacturer", "serialNumber",
      "orderId",    "orderUpdateId", "lastNodeId",  "nodeStates",   "lastNodeSequenceId",
      "edgeStates", "driving",       "paused",      "maps",         "newBaseRequest",
      "errors",     "operatingMode", "safetyState", "actionStates", "information"};
  std::set<std::string> wanted = common;
  if (is_new()) {
    wanted.insert({"powerSupply", "mobileRobotPosition", "instantActionStates"});
  } else {
    wanted.insert({"batteryState", "agvPosition"});
  }
  EXPECT_EQ(keys(state), wanted);
  EXPECT_EQ(state["nodeStates"].size(), 2u);
  EXPECT_EQ(state["nodeStates"][1]["released"], false);
  EXPECT_EQ(state["edgeStates"][0]["edgeId"], "ab");
  EXPECT_EQ(state["operatingMode"], "AUTOMATIC");
  EXPECT_EQ(state["actionStates"][0]["actionStatus"], "WAITING");
  EXPECT_EQ(state["actionStates"].size(), is_new() ? 1u : 2u) << "instant ones in 2.1, too";
  EXPECT_EQ(
      keys(state["errors"][0]),
      (std::set<std::string>{"errorType", "errorLevel", "errorDescription", "errorReferences"}));
  EXPECT_EQ(state["errors"][0]["errorLevel"], "WARNING");
  EXPECT_EQ(state["errors"][0]["errorType"],
            is_new() ? "INVALID_INSTANT_ACTION" : "instantActionError");
  const json& power = state[is_new() ? "powerSupply" : "batteryState"];
  EXPECT_EQ(power[is_new() ? "stateOfCharge" : "batteryCharge"], 80);
  const json& position = state[is_new() ? "mobileRobotPosition" : "agvPosition"];
  EXPECT_EQ(position[is_new() ? "localized" : "positionInitialized"], true);
  const json& safety = state["safetyState"];
  EXPECT_EQ(safety[is_new() ? "activeEmergencyStop" : "eStop"], "NONE");
}

TEST_P(MessagesTest, AFactsheetHasTheFieldsOfItsVersion) {
  const json sheet = due().at("factsheet");
  std::set<std::string> wanted = {"headerId",           "timestamp",      "version",
                                  "manufacturer",       "serialNumber",   "typeSpecification",
                                  "physicalParameters", "protocolLimits", "protocolFeatures",
                                  "loadSpecification"};
  wanted.insert(is_new() ? "mobileRobotGeometry" : "agvGeometry");
  EXPECT_EQ(keys(sheet), wanted);
  std::set<std::string> actions;
  for (const json& action :
       sheet["protocolFeatures"][is_new() ? "mobileRobotActions" : "agvActions"]) {
    actions.insert(action["actionType"].get<std::string>());
  }
  std::set<std::string> offered = {"cancelOrder", "factsheetRequest", "startCharging",
                                   "startPause",  "stateRequest",     "stopPause"};
  if (is_new()) {
    offered.insert({"clearInstantActions", "initializePosition"});
  } else {
    offered.insert("initPosition");
  }
  EXPECT_EQ(actions, offered);
}

/// Each action that the factsheet offers is known.
TEST_P(MessagesTest, WhatTheFactsheetOffersIsTaken) {
  const json sheet = due().at("factsheet");
  for (const json& action :
       sheet["protocolFeatures"][is_new() ? "mobileRobotActions" : "agvActions"]) {
    const auto type = action["actionType"].get<std::string>();
    rig_.instant(type, {{"x", 0}, {"y", 0}, {"theta", 0}});
    for (const Fault& fault : rig_.sut.faults(rig_.vehicle)) {
      EXPECT_NE(fault.type, ErrorType::invalid_instant_action) << type << fault.description;
    }
  }
}

TEST_P(MessagesTest, StatesComeWithChangesAndOtherwiseEveryThirtySeconds) {
  due();
  EXPECT_THAT(names_due(0.5), IsEmpty());
  rig_.vehicle.pose->x_m = 0.1;
  rig_.vehicle.charge_percent = 79;
  rig_.vehicle.silence_s = 0.3;
  EXPECT_THAT(names_due(0.3), IsEmpty()) << "these change always";
  rig_.vehicle.navigation = "driving";
  EXPECT_THAT(names_due(0.3), ElementsAre("state", "visualization"));
  rig_.vehicle.is_charging = true;
  EXPECT_THAT(names_due(0.1), IsEmpty()) << "two are 0.2 s apart";
  EXPECT_THAT(names_due(0.1), ElementsAre("state"));
  EXPECT_THAT(names_due(29.5), ElementsAre("visualization"));
  EXPECT_THAT(names_due(0.5), ElementsAre("state"));
}

TEST_P(MessagesTest, ARequestedStateComesAtOnce) {
  due();
  rig_.step(0.5);
  rig_.instant("stateRequest");
  EXPECT_EQ(due().count("state"), 1u);
}

TEST_P(MessagesTest, ASilentVehicleIsAConnectionThatIsBroken) {
  due();
  rig_.vehicle.silence_s = 3;
  rig_.step(1.5);
  auto all = due();
  EXPECT_EQ(all.at("connection").at("connectionState"),
            is_new() ? "CONNECTION_BROKEN" : "CONNECTIONBROKEN");
  EXPECT_EQ(all.count("visualization"), 0u);
  rig_.step(1.5);
  EXPECT_EQ(due().count("connection"), 0u) << "told once";
  sut_.on_connected();
  EXPECT_EQ(due().count("connection"), 1u) << "the broker has the last will since";
  rig_.vehicle.silence_s = 0.1;
  EXPECT_EQ(due().at("connection").at("connectionState"), "ONLINE");
}

TEST_P(MessagesTest, OfAVehicleThatWasNeverHeardThereIsNoState) {
  rig_.vehicle.silence_s = infinity;
  const auto all = due();
  EXPECT_EQ(all.count("state"), 0u);
  EXPECT_EQ(all.count("connection"), 1u);
  EXPECT_EQ(all.count("factsheet"), 1u);
}

TEST_P(MessagesTest, NumbersOfHeadersCountByTopic) {
  due();
  for (std::uint32_t i = 1; i < 4; ++i) {
    rig_.vehicle.bumper = !rig_.vehicle.bumper;
    rig_.step(0.3);
    EXPECT_EQ(due().at("state").at("headerId"), i);
  }
}

TEST_P(MessagesTest, ALevelOfTheOlderVersionIsWarningOrFatal) {
  rig_.vehicle.navigation_reason = "no_pose";
  json order = rig_.texts.order(2, 2);
  order["edges"][0]["corridor"] = json::object();
  rig_.order(order);
  const json errors = due().at("state").at("errors");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0]["errorLevel"], is_new() ? "CRITICAL" : "WARNING");
  EXPECT_EQ(errors[1]["errorLevel"], "FATAL");
}

}  // namespace
}  // namespace tocsin::vda5050
