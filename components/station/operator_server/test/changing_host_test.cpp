// SPDX-License-Identifier: Apache-2.0
// A host on which topics, services and nodes come and go while clients are there.
#include <gtest/gtest.h>

#include "served.hpp"

namespace tocsin {
namespace {

using nlohmann::json;

foxglove::SeenTopic topic_of(const TopicInfo& info, const TypeInfo& type) {
  return {"/" + std::string(info.name), info, &type};
}

class ChangingHostTest : public ::testing::Test {
 protected:
  ChangingHostTest() {
    picture_.topics = {topic_of(topic::Goal::info, type_info<topic::Goal::Message>()),
                       topic_of(topic::Odom::info, type_info<topic::Odom::Message>())};
    picture_.graph.publishers["/goal"] = {"/mission_control"};
    client_ = served_.client();
  }
  foxglove::HostPicture picture_;
  Served served_{{}, [this] { return picture_; }};
  std::unique_ptr<SocketClient> client_;
};

TEST_F(ChangingHostTest, ATopicThatGoesEndsItsSubscriptionsAndItsPort) {
  served_.subscribe(*client_, "/goal", 1);
  const auto reads = [&] {
    for (const PortHealth& port : served_.sut->port_health()) {
      if (port.topic == "goal") return true;
    }
    return false;
  };
  EXPECT_TRUE(reads());
  const auto id = client_->channel("/goal").value_or(0);
  picture_.topics.erase(picture_.topics.begin());
  ASSERT_TRUE(served_.until([&] { return !client_->heard("unadvertise").empty(); }));
  EXPECT_EQ(client_->heard("unadvertise").front().at("channelIds"), json({id}));
  EXPECT_TRUE(served_.until([&] { return !reads(); }));
  served_.bus.publish<topic::Goal>({});
  served_.settle(*client_);
  EXPECT_TRUE(client_->frames(1).empty());
}

TEST_F(ChangingHostTest, ATopicThatComesBackIsAnotherChannelWithTheSameMessages) {
  const auto before = client_->channel("/goal");
  const auto goal = picture_.topics.front();
  picture_.topics.erase(picture_.topics.begin());
  ASSERT_TRUE(served_.until([&] { return !client_->heard("unadvertise").empty(); }));
  picture_.topics.push_back(goal);
  ASSERT_TRUE(served_.until([&] { return client_->channel("/goal") != before; }));
  served_.subscribe(*client_, "/goal", 1);
  served_.bus.publish<topic::Goal>({});
  EXPECT_TRUE(served_.until([&] { return client_->frames(1).size() == 1; }));
}

TEST_F(ChangingHostTest, TheGraphIsToldToWhoAsksForItUntilItDoesNotAnyMore) {
  client_->say({{"op", "subscribeConnectionGraph"}});
  ASSERT_TRUE(served_.until([&] { return client_->heard("connectionGraphUpdate").size() == 1; }));
  EXPECT_EQ(client_->heard("connectionGraphUpdate").front().at("publishedTopics"),
            json::parse(R"([{"name": "/goal", "publisherIds": ["/mission_control"]}])"));
  picture_.graph.subscribers["/goal"] = {"/page"};
  ASSERT_TRUE(served_.until([&] { return client_->heard("connectionGraphUpdate").size() == 2; }));
  EXPECT_EQ(client_->heard("connectionGraphUpdate").back().at("publishedTopics"), json::array());
  client_->say({{"op", "unsubscribeConnectionGraph"}});
  served_.settle(*client_);
  picture_.graph.subscribers.clear();
  served_.bus.run_for(std::chrono::seconds(2));
  served_.settle(*client_);
  EXPECT_EQ(client_->heard("connectionGraphUpdate").size(), 2U);
}

TEST_F(ChangingHostTest, ANodeThatDoesNotAnswerHasNoParametersAndIsNamed) {
  OperatorServerComponent::Params params;
  params.service_timeout_s = 0.2;
  Served served(params);
  tocsin_msgs::msg::ContainerState state;
  tocsin_msgs::msg::ComponentState silent;
  silent.name("silent");
  state.components({silent});
  const auto client = served.client();
  served.bus.publish<topic::ContainerState>(state);
  served.bus.run_for(std::chrono::milliseconds(1));
  client->say({{"op", "getParameters"}, {"parameterNames", {"/silent.x"}}, {"id", "one"}});
  EXPECT_TRUE(served.until([&] { return !client->heard("parameterValues").empty(); }));
  EXPECT_TRUE(client->was_told("/silent: did not answer for its parameters"));
}

}  // namespace
}  // namespace tocsin
