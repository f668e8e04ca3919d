// SPDX-License-Identifier: Apache-2.0
#include "operator_server/server_message.hpp"

#include <gtest/gtest.h>

namespace tocsin::foxglove {
namespace {

using nlohmann::json;
using namespace std::string_literals;

json parsed(const Frame& frame) {
  EXPECT_EQ(frame.kind, Frame::Kind::text);
  return json::parse(frame.head);
}

TEST(ServerMessageTest, SaysWhatTheServerIs) {
  EXPECT_EQ(parsed(server_info({"Tocsin", "17", {{"host", "gcs"}}})),
            json::parse(R"({"op": "serverInfo", "name": "Tocsin", "sessionId": "17",
              "capabilities": ["clientPublish", "parameters", "parametersSubscribe", "services",
                               "connectionGraph", "time"],
              "supportedEncodings": ["cdr", "json"], "metadata": {"host": "gcs"}})"));
}

TEST(ServerMessageTest, AdvertisesChannelsAndServices) {
  EXPECT_EQ(parsed(advertise({{3, {"/odom", {"nav_msgs/msg/Odometry", "ros2msg", "int32 x"}}}})),
            json::parse(R"({"op": "advertise", "channels": [{"id": 3, "topic": "/odom",
              "encoding": "cdr", "schemaName": "nav_msgs/msg/Odometry",
              "schemaEncoding": "ros2msg", "schema": "int32 x"}]})"));
  EXPECT_EQ(parsed(unadvertise({3})), json::parse(R"({"op": "unadvertise", "channelIds": [3]})"));
  const json service = parsed(advertise_services(
      {{4, {"/dock", "std_srvs/srv/Trigger", {"q", "ros2msg", "a"}, {"r", "ros2msg", "b"}}}}));
  EXPECT_EQ(service.at("services").at(0).at("request"),
            json::parse(R"({"encoding": "cdr", "schemaName": "q", "schemaEncoding": "ros2msg",
                            "schema": "a"})"));
  EXPECT_EQ(service.at("services").at(0).at("responseSchema"), "b");
  EXPECT_EQ(parsed(unadvertise_services({4})),
            json::parse(R"({"op": "unadvertiseServices", "serviceIds": [4]})"));
}

TEST(ServerMessageTest, SaysStatusAndTakesItBack) {
  EXPECT_EQ(parsed(status(Level::warning, "slow", "drops")),
            json::parse(R"({"op": "status", "level": 1, "message": "slow", "id": "drops"})"));
  EXPECT_EQ(parsed(status(Level::error, "bad")),
            json::parse(R"({"op": "status", "level": 2, "message": "bad"})"));
  EXPECT_EQ(parsed(remove_status("drops")),
            json::parse(R"({"op": "removeStatus", "statusIds": ["drops"]})"));
}

TEST(ServerMessageTest, TextsOfOthersMayBeAnyBytes) {
  EXPECT_NO_THROW((void)parsed(status(Level::error, "\xff\x01 bad")));
}

TEST(ServerMessageTest, SaysParameters) {
  EXPECT_EQ(parsed(parameter_values({{"/a.b", 1.5, "float64"}, {"/a.c", nullptr, ""}}, "x")),
            json::parse(R"({"op": "parameterValues", "id": "x",
              "parameters": [{"name": "/a.b", "value": 1.5, "type": "float64"}, {"name": "/a.c"}]})"));
}

TEST(ServerMessageTest, BinaryFramesAreLittleEndian) {
  const auto payload = std::make_shared<const std::vector<std::uint8_t>>(3, std::uint8_t{9});
  const Frame data = message_data(0x01020304, 0x0102030405060708, payload);
  EXPECT_EQ(data.kind, Frame::Kind::binary);
  EXPECT_EQ(data.head, "\x01\x04\x03\x02\x01\x08\x07\x06\x05\x04\x03\x02\x01"s);
  EXPECT_EQ(data.size(), 16U);
  EXPECT_EQ(time(1).head, "\x02\x01\x00\x00\x00\x00\x00\x00\x00"s);
  EXPECT_EQ(service_response({1, 2, "cdr", ""}, payload).head,
            "\x03\x01\x00\x00\x00\x02\x00\x00\x00\x03\x00\x00\x00"
            "cdr"s);
}

/// The lists of an update, by their keys.
json update_of(const Graph& before, const Graph& now) { return parsed(graph_update(before, now)); }

TEST(GraphUpdateTest, TellsOnlyWhatHasChanged) {
  Graph before;
  before.publishers["/odom"] = {"/driver"};
  before.publishers["/goal"] = {"/mission"};
  Graph now = before;
  now.publishers["/odom"].insert("/simulator");
  const json update = update_of(before, now);
  EXPECT_EQ(update.at("publishedTopics"),
            json::parse(R"([{"name": "/odom", "publisherIds": ["/driver", "/simulator"]}])"));
  EXPECT_EQ(update.at("subscribedTopics"), json::array());
}

TEST(GraphUpdateTest, ATopicIsGoneWhenNobodyWritesOrReadsIt) {
  Graph before;
  before.publishers["/odom"] = {"/driver"};
  before.subscribers["/odom"] = {"/navigator"};
  before.servers["/dock"] = {"/driver"};
  Graph reading = before;
  reading.publishers.clear();
  const json silent = update_of(before, reading);
  EXPECT_EQ(silent.at("publishedTopics"),
            json::parse(R"([{"name": "/odom", "publisherIds": []}])"));
  EXPECT_EQ(silent.at("removedTopics"), json::array());
  Graph writing = before;
  writing.subscribers.clear();
  EXPECT_EQ(update_of(before, writing).at("subscribedTopics"),
            json::parse(R"([{"name": "/odom", "subscriberIds": []}])"));
  const json gone = update_of(before, {});
  EXPECT_EQ(gone.at("removedTopics"), json({"/odom"}));
  EXPECT_EQ(gone.at("removedServices"), json({"/dock"}));
  EXPECT_EQ(gone.at("publishedTopics"), json::array());
}

}  // namespace
}  // namespace tocsin::foxglove
