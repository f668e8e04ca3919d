// SPDX-License-Identifier: Apache-2.0
// What Foxglove Studio and Lichtblick do by themselves, before anybody has clicked anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "operator_server/access.hpp"
#include "operator_server/hub.hpp"

namespace tocsin::foxglove {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace std::string_literals;

constexpr std::uint64_t noon_ns = 1'764'072'000'000'000'000;

class StudioClientTest : public ::testing::Test {
 protected:
  static HubSettings settings(const std::vector<std::string>& writable) {
    HubSettings made;
    made.writable = writable;
    return made;
  }
  /// As Studio's 3D panel does at its start.
  static std::vector<Order> open_customary(Hub& hub) {
    json channels = json::array();
    std::uint32_t id = 0;
    for (const char* topic : {"/move_base_simple/goal", "/clicked_point", "/initialpose"}) {
      channels.push_back({{"id", ++id},
                          {"topic", topic},
                          {"encoding", "json"},
                          {"schemaName", "geometry_msgs/msg/PoseStamped"}});
    }
    return hub.on_frame(1, Frame::Kind::text,
                        json({{"op", "advertise"}, {"channels", channels}}).dump());
  }
  static std::vector<Order> publish(Hub& hub, char channel) {
    return hub.on_frame(1, Frame::Kind::binary, "\x01"s + channel + "\0\0\0{}"s);
  }
  static std::vector<std::string> told(Hub& hub) {
    std::vector<std::string> texts;
    for (const Frame& frame : hub.take(1, 100'000'000)) texts.push_back(frame.head);
    return texts;
  }
};

TEST_F(StudioClientTest, HearsTheTimeRightAfterServerInfo) {
  Hub sut(settings({}));
  sut.set_channels({{"/a", {"pkg/msg/Type", "ros2msg", "int32 x"}, false}});
  sut.add_client(1, noon_ns);
  EXPECT_THAT(told(sut),
              ElementsAre(HasSubstr("serverInfo"), time(noon_ns).head, HasSubstr("advertise")));
}

TEST_F(StudioClientTest, TopicsThatA3dPanelHasOpenAreNoFault) {
  Hub sut(settings({"/goal"}));
  sut.add_client(1, noon_ns);
  (void)told(sut);
  EXPECT_THAT(open_customary(sut), IsEmpty());
  EXPECT_THAT(told(sut), IsEmpty());
  EXPECT_THAT(sut.written(), IsEmpty());
}

TEST_F(StudioClientTest, AClickThatNobodyTakesIsOneWarning) {
  Hub sut(settings({"/goal"}));
  sut.add_client(1, noon_ns);
  (void)open_customary(sut);
  (void)told(sut);
  EXPECT_THAT(publish(sut, '\x02'), IsEmpty());
  EXPECT_THAT(told(sut), ElementsAre(AllOf(HasSubstr("/clicked_point: nobody here takes it"),
                                           HasSubstr(R"("level":1)"))));
  EXPECT_THAT(publish(sut, '\x02'), IsEmpty());
  EXPECT_THAT(told(sut), IsEmpty());
  EXPECT_THAT(publish(sut, '\x01'), IsEmpty());
  EXPECT_THAT(told(sut), ElementsAre(HasSubstr("/move_base_simple/goal: nobody here takes it")));
}

TEST_F(StudioClientTest, CannotMakeTheServerRememberMoreAndMoreTopics) {
  Hub sut(settings({}));
  sut.add_client(1, noon_ns);
  json channels = json::array();
  for (std::uint32_t id = 0; id < 150; ++id) {
    channels.push_back({{"id", id},
                        {"topic", "/clicked_point"},
                        {"encoding", "json"},
                        {"schemaName", "geometry_msgs/msg/PointStamped"}});
  }
  (void)told(sut);
  (void)sut.on_frame(1, Frame::Kind::text,
                     json({{"op", "advertise"}, {"channels", channels}}).dump());
  EXPECT_EQ(told(sut).size(), 50U);
}

RequestFacts request_of(const std::string& origin) {
  RequestFacts request;
  request.method = "GET";
  request.target = "/";
  request.host = "127.0.0.1:8765";
  request.origin = origin;
  request.protocols = "foxglove.websocket.v1";
  request.wants_socket = true;
  return request;
}
bool is_let_in(const AccessRules& rules, const std::string& origin) {
  return std::holds_alternative<OpenSocket>(judge(rules, request_of(origin)));
}

TEST(StudioOriginTest, IsLetInOnLoopback) {
  for (const char* origin : {"file://", "app://foxglove", "https://app.foxglove.dev",
                             "https://studio.foxglove.dev", "http://localhost:8080"}) {
    EXPECT_TRUE(is_let_in({"127.0.0.1"}, origin)) << origin;
    EXPECT_FALSE(is_let_in({"0.0.0.0", {{"0123456789abcdef"}}, true}, origin)) << origin;
  }
}

TEST(StudioOriginTest, IsNoOriginThatLooksAlikeOrThatAnyPageCanHave) {
  for (const char* origin : {"null", "https://app.foxglove.dev.evil.example", "app://foxglove2",
                             "http://app.foxglove.dev", "file:", "http://localhost:8081"}) {
    EXPECT_FALSE(is_let_in({"127.0.0.1"}, origin)) << origin;
  }
}

TEST(StudioOriginTest, WhoIsRefusedReadsTheSettingThatLetsItIn) {
  const Verdict verdict = judge({"127.0.0.1"}, request_of("http://localhost:8081"));
  EXPECT_THAT(std::get<Refuse>(verdict).reason,
              HasSubstr("operator_server.origins: [http://localhost:8081] lets it in"));
  AccessRules rules{"127.0.0.1"};
  rules.origins = {"null"};
  EXPECT_TRUE(is_let_in(rules, "null"));
}

}  // namespace
}  // namespace tocsin::foxglove
