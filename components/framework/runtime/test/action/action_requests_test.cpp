// SPDX-License-Identifier: Apache-2.0
// Requests that a client of other vendors may send to an action's server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "action/action_rig.hpp"

namespace tocsin {
namespace {

using What = ActionClient<Fibonacci>::What;

/// A client that has the services only, as those of other vendors, and sends what it likes.
template <class Service>
class RawClient : private ClientReceiver {
 public:
  RawClient(SimBus& bus, const std::string& name)
      : bus_(bus),
        end_(bus.call({name, &type_info<typename Service::Request>(),
                       &type_info<typename Service::Response>()},
                      *this)) {}
  std::shared_ptr<const typename Service::Response> ask(const typename Service::Request& request) {
    reply_.reset();
    EXPECT_TRUE(end_->send(std::make_shared<const typename Service::Request>(request)));
    bus_.run_for(seconds(0.1));
    return std::static_pointer_cast<const typename Service::Response>(reply_);
  }

 private:
  void receive(ServiceReply&& reply) override { reply_ = reply.message; }
  void wake() override {}
  SimBus& bus_;
  std::shared_ptr<const void> reply_;
  std::unique_ptr<ClientEnd> end_;
};
struct SendGoal {
  using Request = wire::Fibonacci_SendGoal_Request;
  using Response = wire::Fibonacci_SendGoal_Response;
};
struct GetResult {
  using Request = wire::Fibonacci_GetResult_Request;
  using Response = wire::Fibonacci_GetResult_Response;
};

TEST_F(ActionPortTest, AnIdThatIsTakenIsRejected) {
  start_server();
  RawClient<SendGoal> sut(bus_, "fibonacci/_action/send_goal");
  SendGoal::Request request;
  request.goal_id().uuid()[0] = 9;
  request.goal().order(80);
  EXPECT_TRUE(sut.ask(request)->accepted());
  EXPECT_FALSE(sut.ask(request)->accepted());
}

TEST_F(ActionPortTest, TheResultOfAGoalThatNobodyKnowsIsUnknown) {
  start_server();
  RawClient<GetResult> sut(bus_, "fibonacci/_action/get_result");
  const auto answer = sut.ask({});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status(), 0);
}

TEST_F(ActionPortTest, AResultIsKeptForTenSeconds) {
  start_server();
  const GoalId id = send(2);
  bus_.run_for(seconds(2));
  RawClient<GetResult> sut(bus_, "fibonacci/_action/get_result");
  GetResult::Request request;
  request.goal_id().uuid(id);
  bus_.run_for(seconds(8));
  EXPECT_EQ(sut.ask(request)->status(), 4);
  bus_.run_for(seconds(3));
  EXPECT_EQ(sut.ask(request)->status(), 0);
}

TEST_F(ActionPortTest, WithoutIdAllGoalsAreCanceled) {
  start_server();
  const GoalId one = send(80);
  const GoalId other = send(80);
  bus_.run_for(seconds(1.5));
  RawClient<CancelGoal> sut(bus_, "fibonacci/_action/cancel_goal");
  const auto answer = sut.ask({});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->goals_canceling().size(), 2U);
  bus_.run_for(seconds(2));
  EXPECT_EQ(news_of(one).back(), What::result);
  EXPECT_EQ(news_of(other).back(), What::result);
}

TEST(GoalIdsTest, AreOfVersionFourAndDiffer) {
  SimBus bus;
  Context one_context{bus, "one", Role::uxv};
  Context other_context{bus, "other", Role::uxv};
  Asker one(one_context);
  Asker other(other_context);
  GoalIds sut(one);
  GoalIds others(other);
  const GoalId first = sut.next();
  EXPECT_EQ(first[6] >> 4U, 4);
  EXPECT_EQ(first[8] >> 6U, 2);
  EXPECT_NE(first, sut.next());
  EXPECT_NE(first, others.next());
}

}  // namespace
}  // namespace tocsin
