// SPDX-License-Identifier: Apache-2.0
#include "operator_server/client_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace tocsin::foxglove {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::string_literals;

std::string fault_of(const ClientMessage& message) {
  const auto* const fault = std::get_if<ProtocolFault>(&message);
  return fault == nullptr ? "no fault" : fault->reason;
}

TEST(ClientMessageTest, ReadsSubscriptions) {
  const auto message = parse_text(
      R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 4294967295, "x": 1}]})");
  const auto& wishes = std::get<Subscribe>(message).wishes;
  ASSERT_EQ(wishes.size(), 1U);
  EXPECT_EQ(wishes[0].id, 1U);
  EXPECT_EQ(wishes[0].channel, 4294967295U);
  EXPECT_THAT(
      std::get<Unsubscribe>(parse_text(R"({"op": "unsubscribe", "subscriptionIds": [1, 2]})")).ids,
      ElementsAre(1U, 2U));
}

TEST(ClientMessageTest, ReadsChannelsOfTheClient) {
  const auto message = parse_text(
      R"({"op": "advertise", "channels": [{"id": 2, "topic": "/goal", "encoding": "json",
          "schemaName": "tocsin_msgs/msg/Goal", "schema": "x"}]})");
  const auto& channels = std::get<Advertise>(message).channels;
  ASSERT_EQ(channels.size(), 1U);
  EXPECT_EQ(channels[0].topic, "/goal");
  EXPECT_EQ(channels[0].schema_name, "tocsin_msgs/msg/Goal");
  EXPECT_THAT(std::get<Unadvertise>(parse_text(R"({"op": "unadvertise", "channelIds": [2]})")).ids,
              ElementsAre(2U));
}

TEST(ClientMessageTest, ReadsParametersAndTheirRequestIds) {
  const auto asked = std::get<GetParameters>(
      parse_text(R"({"op": "getParameters", "parameterNames": ["/a.b"], "id": "x"})"));
  EXPECT_THAT(asked.names, ElementsAre("/a.b"));
  EXPECT_EQ(asked.id, "x");
  const auto set = std::get<SetParameters>(parse_text(
      R"({"op": "setParameters", "parameters": [{"name": "/a.b", "value": 1.5, "type": "float64"}]})"));
  ASSERT_EQ(set.parameters.size(), 1U);
  EXPECT_EQ(set.parameters[0].value, 1.5);
  EXPECT_EQ(set.parameters[0].type, "float64");
  EXPECT_FALSE(set.id);
}

TEST(ClientMessageTest, ReadsBinaryFrames) {
  const auto data = std::get<Publish>(parse_binary("\x01\x05\x00\x00\x01hello"s));
  EXPECT_EQ(data.channel, 0x01000005U);
  EXPECT_EQ(data.payload, "hello");
  const auto call =
      std::get<CallService>(parse_binary("\x02\x01\x00\x00\x00\x02\x00\x00\x00\x03\x00\x00\x00"
                                         "cdrXY"s));
  EXPECT_EQ(call.service, 1U);
  EXPECT_EQ(call.call, 2U);
  EXPECT_EQ(call.encoding, "cdr");
  EXPECT_EQ(call.payload, "XY");
}

TEST(ClientMessageTest, EachBadFrameHasOneFaultThatNamesThePlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "the frame is not JSON"},
      {"{", "the frame is not JSON: {"},
      {"[]", "message: must be an object"},
      {"{}", "message.op: is missing"},
      {R"({"op": 1})", "message.op: must be a text"},
      {R"({"op": "subscrib"})", "op: 'subscrib' is not known here; did you mean 'subscribe'?"},
      {R"({"op": "fetchAsset"})", "op: 'fetchAsset' is not known here; known are"},
      {R"({"op": "subscribe"})", "subscribe.subscriptions: is missing"},
      {R"({"op": "subscribe", "subscriptions": {}})", "subscribe.subscriptions: must be a list"},
      {R"({"op": "subscribe", "subscriptions": [1]})", "subscriptions[0]: must be an object"},
      {R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": -1}]})",
       "subscriptions[0].channelId: must be a whole number in [0, 4294967295]"},
      {R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 4294967296}]})",
       "subscriptions[0].channelId: must be a whole number in [0, 4294967295]"},
      {R"({"op": "unsubscribe", "subscriptionIds": [1.5]})", "subscriptionIds[0]: must be a whole"},
      {R"({"op": "getParameters", "parameterNames": [1]})", "parameterNames[0]: must be a text"},
      {R"({"op": "setParameters", "parameters": [{}]})", "parameters[0].name: is missing"},
  };
  for (const auto& [frame, fault] : cases) {
    EXPECT_THAT(fault_of(parse_text(frame)), HasSubstr(fault)) << frame;
  }
}

TEST(ClientMessageTest, BinaryFramesThatEndTooEarlyAreFaults) {
  EXPECT_THAT(fault_of(parse_binary("")), HasSubstr("is empty"));
  EXPECT_THAT(fault_of(parse_binary("\x01\x05"s)), HasSubstr("ends before its channel"));
  EXPECT_THAT(fault_of(parse_binary("\x07"s)), HasSubstr("opcode 7, not 1"));
  const std::string longer =
      "\x02\x01\x00\x00\x00\x02\x00\x00\x00\xff\xff\xff\xff"
      "cdr"s;
  EXPECT_THAT(fault_of(parse_binary(longer)), HasSubstr("ends before its payload"));
}

/// Frames that were sound once: bits turned, cut, put together anew.
TEST(ClientMessageTest, NoFrameDoesMoreThanToBeRefused) {
  const std::string sound[] = {
      R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 2}]})",
      R"({"op": "advertise", "channels": [{"id": 2, "topic": "/a", "encoding": "json", "schemaName": "s"}]})",
      R"({"op": "setParameters", "parameters": [{"name": "/a.b", "value": [1, {"x": 2}]}], "id": "x"})",
      "\x02\x01\x00\x00\x00\x02\x00\x00\x00\x03\x00\x00\x00"
      "cdrXY"s,
      "\x01\x05\x00\x00\x00hello"s};
  std::mt19937 random(20);
  int refused = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string frame = sound[random() % std::size(sound)];
    for (auto changes = 1 + random() % 4; changes > 0 && !frame.empty(); --changes) {
      const std::size_t at = random() % frame.size();
      const auto kind = random() % 3;
      if (kind == 0) frame[at] = static_cast<char>(random());
      if (kind == 1) frame.resize(at);
      if (kind == 2) frame.insert(at, sound[random() % std::size(sound)].substr(at % 10, 9));
    }
    for (const ClientMessage& message : {parse_text(frame), parse_binary(frame)}) {
      const auto* const fault = std::get_if<ProtocolFault>(&message);
      if (fault == nullptr) continue;
      ++refused;
      ASSERT_FALSE(fault->reason.empty());
      ASSERT_EQ(fault->reason.find('\n'), std::string::npos) << fault->reason;
    }
  }
  EXPECT_GT(refused, 50'000);
}

TEST(ClientMessageTest, AFrameThatIsTooDeepIsRefusedBeforeItIsRead) {
  EXPECT_THAT(fault_of(parse_text(std::string(1'000'000, '['))), HasSubstr("deeper than 32"));
  const std::string brackets(100, '[');
  EXPECT_THAT(fault_of(parse_text(R"({"op": ")" + brackets + R"(\""})")),
              HasSubstr("is not known"));
}

}  // namespace
}  // namespace tocsin::foxglove
