// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/local_services.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using Names = std::vector<std::string>;

struct Servant : ServerReceiver {
  void receive(ServiceRequest&& request) override { requests.push_back(std::move(request)); }
  void wake() override {}
  std::vector<ServiceRequest> requests;
};

struct Asker : ClientReceiver {
  void receive(ServiceReply&& reply) override { replies.push_back(std::move(reply)); }
  void wake() override { ++woken; }
  std::vector<ServiceReply> replies;
  int woken = 0;
};

const ServiceEndpoint dock{"dock", nullptr, nullptr};
const std::shared_ptr<const void> message = std::make_shared<const int>(5);
const std::shared_ptr<const void> answer = std::make_shared<const int>(6);

class LocalServicesTest : public ::testing::Test {
 protected:
  LocalServices sut_;
  Servant servant_;
  Asker asker_;
};

TEST_F(LocalServicesTest, HandTheMessageItselfThereAndBack) {
  const auto server = sut_.serve(dock, servant_);
  const auto client = sut_.call(dock, asker_);
  const auto number = client->send(message);
  ASSERT_TRUE(number);
  ASSERT_EQ(servant_.requests.size(), 1U);
  EXPECT_EQ(servant_.requests[0].message, message);
  server->reply(servant_.requests[0].id, answer);
  ASSERT_EQ(asker_.replies.size(), 1U);
  EXPECT_EQ(asker_.replies[0].message, answer);
  EXPECT_EQ(asker_.replies[0].number, *number);
}

TEST_F(LocalServicesTest, AnswerTheClientThatAskedAndNoOther) {
  Asker other;
  const auto server = sut_.serve(dock, servant_);
  const auto client = sut_.call(dock, asker_);
  const auto another = sut_.call(dock, other);
  ASSERT_TRUE(another->send(message));
  server->reply(servant_.requests[0].id, answer);
  EXPECT_TRUE(asker_.replies.empty());
  EXPECT_EQ(other.replies.size(), 1U);
}

TEST_F(LocalServicesTest, SendNothingWithoutAServer) {
  const auto client = sut_.call(dock, asker_);
  EXPECT_FALSE(client->available());
  EXPECT_FALSE(client->send(message));
}

TEST_F(LocalServicesTest, WakeTheClientsWhenAServerComesAndGoes) {
  const auto client = sut_.call(dock, asker_);
  auto server = sut_.serve(dock, servant_);
  EXPECT_EQ(asker_.woken, 1);
  EXPECT_TRUE(client->available());
  server.reset();
  EXPECT_EQ(asker_.woken, 2);
  EXPECT_FALSE(client->available());
}

TEST_F(LocalServicesTest, DropTheReplyForAClientThatHasGone) {
  const auto server = sut_.serve(dock, servant_);
  auto client = sut_.call(dock, asker_);
  ASSERT_TRUE(client->send(message));
  client.reset();
  server->reply(servant_.requests[0].id, answer);
  EXPECT_TRUE(asker_.replies.empty());
}

TEST_F(LocalServicesTest, AskTheFirstOfTwoServers) {
  Servant second;
  auto first = sut_.serve(dock, servant_);
  const auto other = sut_.serve(dock, second);
  const auto client = sut_.call(dock, asker_);
  ASSERT_TRUE(client->send(message));
  EXPECT_EQ(servant_.requests.size(), 1U);
  first.reset();
  ASSERT_TRUE(client->send(message));
  EXPECT_EQ(second.requests.size(), 1U);
}

TEST_F(LocalServicesTest, TellWhatIsCalled) {
  const auto server = sut_.serve({"undock", nullptr, nullptr}, servant_);
  EXPECT_TRUE(sut_.called().empty());
  auto client = sut_.call({"~/reset", nullptr, nullptr, "arm"}, asker_);
  EXPECT_EQ(sut_.called(), Names{"arm/reset"});
  client.reset();
  EXPECT_TRUE(sut_.called().empty());
}

}  // namespace
}  // namespace tocsin
