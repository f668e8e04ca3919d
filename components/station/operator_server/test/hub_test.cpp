// SPDX-License-Identifier: Apache-2.0
#include "operator_server/hub.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace tocsin::foxglove {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::string_literals;

constexpr std::size_t all = 100'000'000;

Channel channel(const std::string& topic, bool latched = false) {
  return {topic, {"pkg/msg/Type", "ros2msg", "int32 x"}, latched};
}
SharedBytes bytes(const std::string& text) {
  return std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end());
}

class HubTest : public ::testing::Test {
 protected:
  HubTest() : sut_(settings()) {
    sut_.set_channels({channel("/a"), channel("/state", true)});  // 1 and 2
    sut_.add_client(1, 0);
    (void)sut_.take(1, all);
  }
  static HubSettings settings() {
    HubSettings made;
    made.writable = {"/goal", "/drive*"};
    return made;
  }
  std::vector<Order> say(ClientId client, const json& message) {
    return sut_.on_frame(client, Frame::Kind::text, message.dump());
  }
  void subscribe(ClientId client, std::uint32_t id, std::uint32_t to) {
    EXPECT_TRUE(
        say(client, {{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", to}}}}})
            .empty());
  }
  std::vector<Order> open(ClientId client, const std::string& topic,
                          const std::string& encoding = "cdr", std::uint32_t id = 1) {
    return say(client, {{"op", "advertise"},
                        {"channels",
                         {{{"id", id},
                           {"topic", topic},
                           {"encoding", encoding},
                           {"schemaName", "pkg/msg/Type"}}}}});
  }
  std::vector<Order> publish(ClientId client, const std::string& payload) {
    return sut_.on_frame(client, Frame::Kind::binary, "\x01\x01\x00\x00\x00"s + payload);
  }
  /// Texts of all control, and "data" and payload of all else.
  std::vector<std::string> told(ClientId client) {
    std::vector<std::string> texts;
    for (const Frame& frame : sut_.take(client, all)) {
      texts.push_back(
          frame.kind == Frame::Kind::text
              ? frame.head
              : "data " + (frame.payload ? std::string(frame.payload->begin(), frame.payload->end())
                                         : ""));
    }
    return texts;
  }
  Hub sut_;
};

TEST_F(HubTest, OnlySubscribersGetAMessage) {
  sut_.add_client(2, 0);
  (void)told(2);
  subscribe(1, 7, 1);
  EXPECT_THAT(sut_.heard(), ElementsAre("/a"));
  sut_.on_message("/a", 5, bytes("one"));
  sut_.on_message("/state", 5, bytes("other"));
  EXPECT_THAT(told(1), ElementsAre("data one"));
  EXPECT_TRUE(told(2).empty());
}

TEST_F(HubTest, ALateSubscriberGetsTheLastStateWhileAnotherHearsIt) {
  subscribe(1, 7, 2);
  sut_.on_message("/state", 5, bytes("last"));
  sut_.add_client(2, 0);
  subscribe(2, 7, 2);
  (void)told(1);
  EXPECT_THAT(told(2).back(), "data last");
  for (const ClientId client : {1U, 2U}) sut_.remove_client(client);
  sut_.add_client(3, 0);
  subscribe(3, 7, 2);
  EXPECT_THAT(told(3).back(), HasSubstr("advertise")) << "nobody knows what it is now";
}

TEST_F(HubTest, ALateSubscriberGetsTheLastStateOfEachWriter) {
  subscribe(1, 7, 2);
  sut_.on_message("/state", 5, bytes("uxv 1"), 1);
  sut_.on_message("/state", 6, bytes("gcs 1"), 2);
  sut_.on_message("/state", 7, bytes("uxv 2"), 1);
  sut_.add_client(2, 0);
  (void)told(2);
  subscribe(2, 7, 2);
  EXPECT_THAT(told(2), ElementsAre("data gcs 1", "data uxv 2"));
}

TEST_F(HubTest, ASlowClientGetsTheNewestAndIsToldWhatItMissed) {
  subscribe(1, 7, 1);
  for (int i = 0; i < 5; ++i) sut_.on_message("/a", 5, bytes(std::to_string(i)));
  sut_.tell_drops();
  EXPECT_THAT(told(1), ElementsAre(HasSubstr("messages dropped: 3 of /a"), "data 3", "data 4"));
  EXPECT_EQ(sut_.drops(), 3U);
  sut_.tell_drops();
  EXPECT_THAT(told(1), ElementsAre(R"({"op":"removeStatus","statusIds":["drops"]})"));
  sut_.tell_drops();
  EXPECT_TRUE(told(1).empty());
}

TEST_F(HubTest, AClientThatReadsNothingHasToGo) {
  sut_.add_client(2, 0);
  const std::string longest(20'000, 'x');
  for (int i = 0; i < 500; ++i) sut_.tell(2, Level::info, longest);
  EXPECT_THAT(sut_.overflown(), ElementsAre(2U));
  sut_.remove_client(2);
  EXPECT_TRUE(sut_.overflown().empty());
  EXPECT_TRUE(sut_.take(2, all).empty());
}

TEST_F(HubTest, RefusesWhatAClientMayNotPublish) {
  EXPECT_TRUE(open(1, "/cmd_vel").empty());
  EXPECT_TRUE(open(1, "/goal", "protobuf").empty());
  EXPECT_FALSE(open(1, "/goal").empty());
  EXPECT_TRUE(open(1, "/goal").empty());
  EXPECT_THAT(told(1), ElementsAre(HasSubstr("/cmd_vel: clients may not publish here"),
                                   HasSubstr("encoding 'protobuf' is not one of"),
                                   HasSubstr("channel 1 of this client is there already")));
  sut_.refuse_topic(1, 1, "why");
  EXPECT_TRUE(sut_.written().empty());
  EXPECT_THAT(told(1), ElementsAre(HasSubstr("why")));
}

TEST_F(HubTest, CallsOfServicesAreAnsweredToWhoAsked) {
  Service service{"/dock", "std_srvs/srv/Trigger", {"a", "ros2msg", ""}, {"b", "ros2msg", ""}};
  sut_.set_services({service});
  EXPECT_THAT(told(1), ElementsAre(HasSubstr("advertiseServices")));
  const std::string request = "\x03\x00\x00\x00\x09\x00\x00\x00\x03\x00\x00\x00"s + "cdr";
  auto orders = sut_.on_frame(1, Frame::Kind::binary, "\x02" + request);
  ASSERT_EQ(orders.size(), 1U);
  const auto& order = std::get<AskService>(orders[0]);
  EXPECT_EQ(order.name, "/dock");
  sut_.answer_service(1, order.call, bytes("done"));
  const auto frames = sut_.take(1, all);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].head, "\x03" + request);
  sut_.set_services({});
  EXPECT_TRUE(sut_.on_frame(1, Frame::Kind::binary, "\x02" + request).empty());
  EXPECT_THAT(told(1),
              ElementsAre(HasSubstr("unadvertiseServices"), HasSubstr("serviceCallFailure")));
}

TEST_F(HubTest, AnswersToAClientThatHasGoneGoNowhere) {
  sut_.remove_client(1);
  sut_.tell(1, Level::error, "x");
  sut_.refuse_topic(1, 1, "x");
  sut_.answer_parameters(1, {}, "id");
  sut_.answer_service(1, {}, bytes("x"));
  sut_.fail_service(1, {}, "x");
  EXPECT_TRUE(say(1, {{"op", "subscribeConnectionGraph"}}).empty());
  EXPECT_TRUE(told(1).empty());
  EXPECT_EQ(sut_.clients(), 0U);
}

/// Whatever clients say, the hub stays sound: those who say nothing bad hear all the same.
TEST_F(HubTest, NoFramesOfOneClientHarmAnother) {
  sut_.add_client(2, 0);
  (void)told(2);
  subscribe(2, 1, 1);
  const json sound[] = {
      {{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", 1}}}}},
      {{"op", "unsubscribe"}, {"subscriptionIds", {1}}},
      {{"op", "advertise"},
       {"channels", {{{"id", 1}, {"topic", "/drive1"}, {"encoding", "cdr"}, {"schemaName", "x"}}}}},
      {{"op", "unadvertise"}, {"channelIds", {1}}},
      {{"op", "getParameters"}, {"parameterNames", {"/a.b"}}},
      {{"op", "subscribeConnectionGraph"}}};
  std::mt19937 random(7);
  for (int i = 0; i < 3'000; ++i) {
    std::string frame = sound[random() % std::size(sound)].dump();
    const auto at = random() % frame.size();
    if (random() % 2 == 0) frame[at] = static_cast<char>('0' + random() % 10);
    (void)sut_.on_frame(1, Frame::Kind::text, frame);
    (void)sut_.on_frame(1, Frame::Kind::binary, frame.substr(at));
    if (i % 100 == 0) (void)told(1);
  }
  sut_.on_message("/a", 5, bytes("sound"));
  EXPECT_THAT(told(2), ElementsAre("data sound"));
}

TEST_F(HubTest, AnObserverReadsAndPressesTheEmergencyStop) {
  HubSettings of_site = settings();
  of_site.writable.emplace_back("/uxv1/emergency_stop/request");
  Hub site(of_site);
  const auto say_there = [&](const json& message) {
    return site.on_frame(2, Frame::Kind::text, message.dump());
  };
  const auto open_there = [&](const std::string& topic, std::uint32_t id) {
    return say_there(
        {{"op", "advertise"},
         {"channels",
          {{{"id", id}, {"topic", topic}, {"encoding", "cdr"}, {"schemaName", "p/T"}}}}});
  };
  site.set_services({{"/serve", "pkg/srv/Type", {}, {}}});
  site.add_client(2, 0, UserRole::observer);
  const auto first = site.take(2, all);
  EXPECT_THAT(first.at(0).head, HasSubstr(R"("role":"observer")"));
  EXPECT_EQ(open_there("/uxv1/emergency_stop/request", 1).size(), 1U);
  const auto pressed = site.on_frame(2, Frame::Kind::binary, "\x01\x01\x00\x00\x00"s + "true");
  ASSERT_EQ(pressed.size(), 1U);
  EXPECT_EQ(std::get<WriteMessage>(pressed[0]).role, UserRole::observer);
  EXPECT_TRUE(open_there("/goal", 2).empty());
  EXPECT_TRUE(say_there({{"op", "setParameters"}, {"parameters", json::array()}}).empty());
  EXPECT_TRUE(site.on_frame(2, Frame::Kind::binary,
                            "\x02\x01\x00\x00\x00\x01\x00\x00\x00\x03\x00\x00\x00"s + "cdr")
                  .empty());
  const auto told_it = site.take(2, all);
  ASSERT_EQ(told_it.size(), 3U);
  EXPECT_THAT(told_it[0].head, HasSubstr("/goal: an observer may not publish here"));
  EXPECT_THAT(told_it[1].head, HasSubstr("an observer may not set them"));
  EXPECT_THAT(told_it[2].head, HasSubstr("an observer may not call services"));
}

}  // namespace
}  // namespace tocsin::foxglove
