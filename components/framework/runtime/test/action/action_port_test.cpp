// SPDX-License-Identifier: Apache-2.0
#include "runtime/action_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "action/action_rig.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using What = ActionClient<Fibonacci>::What;

TEST_F(ActionPortTest, AGoalIsAcceptedToldOfAndEnds) {
  start_server();
  EXPECT_TRUE(asker_.client.available());
  const GoalId id = send(3);
  bus_.run_for(seconds(5));
  EXPECT_THAT(news_of(id),
              ElementsAre(What::accepted, What::feedback, What::feedback, What::result));
  EXPECT_THAT(asker_.news[1].feedback->sequence(), ElementsAre(0, 1, 1));
  EXPECT_EQ(asker_.news[3].state, GoalState::succeeded);
  EXPECT_THAT(asker_.news[3].result->sequence(), ElementsAre(0, 1, 1, 2));
}

TEST_F(ActionPortTest, AGoalThatIsNothingToWorkOnIsRejected) {
  start_server();
  const GoalId id = send(0);
  bus_.run_for(seconds(3));
  EXPECT_THAT(news_of(id), ElementsAre(What::rejected));
  ASSERT_TRUE(asker_.news[0].result);
  EXPECT_THAT(asker_.news[0].result->sequence(), IsEmpty()) << "no reason was given";
}

TEST_F(ActionPortTest, TheReasonOfARejectionReachesTheClient) {
  start_server();
  const GoalId id = send(-3);
  bus_.run_for(seconds(3));
  EXPECT_THAT(news_of(id), ElementsAre(What::rejected));
  ASSERT_TRUE(asker_.news[0].result);
  EXPECT_THAT(asker_.news[0].result->sequence(), ElementsAre(-3));
}

TEST_F(ActionPortTest, OfManyRejectionsEachHasItsOwnReason) {
  start_server();
  for (int i = 1; i <= 100; ++i) {
    send(-i);
    bus_.run_for(seconds(0.1));
    ASSERT_EQ(asker_.news.size(), static_cast<std::size_t>(i));
    ASSERT_TRUE(asker_.news.back().result);
    EXPECT_THAT(asker_.news.back().result->sequence(), ElementsAre(-i));
  }
}

TEST_F(ActionPortTest, AGoalThatIsGivenUpIsAborted) {
  start_server();
  const GoalId id = send(91);
  bus_.run_for(seconds(3));
  EXPECT_THAT(news_of(id), ElementsAre(What::accepted, What::result));
  EXPECT_EQ(asker_.news.back().state, GoalState::aborted);
}

TEST_F(ActionPortTest, AGoalIsCanceledInTheMiddleAndItsResultSaysHowFarItCame) {
  start_server();
  const GoalId id = send(80);
  bus_.run_for(seconds(2.5));
  asker_.client.cancel(id, bus_.now() + seconds(1));
  bus_.run_for(seconds(2));
  const auto news = news_of(id);
  ASSERT_GE(news.size(), 4U);
  EXPECT_EQ(news[news.size() - 2], What::canceling);
  EXPECT_EQ(news.back(), What::result);
  EXPECT_EQ(asker_.news.back().state, GoalState::canceled);
  EXPECT_THAT(asker_.news.back().result->sequence(), ElementsAre(0, 1, 1, 2));
}

TEST_F(ActionPortTest, OneOfTwoGoalsIsCanceled) {
  start_server();
  const GoalId one = send(5);
  const GoalId other = send(5);
  bus_.run_for(seconds(1.5));
  asker_.client.cancel(one, bus_.now() + seconds(1));
  bus_.run_for(seconds(10));
  std::map<GoalId, GoalState> ends;
  for (const auto& news : asker_.news) {
    if (news.what == What::result) ends[news.id] = news.state;
  }
  EXPECT_EQ(ends[one], GoalState::canceled);
  EXPECT_EQ(ends[other], GoalState::succeeded);
}

TEST_F(ActionPortTest, AGoalThatIsOverIsNotEnded) {
  start_server();
  const GoalId id = send(2);
  bus_.run_for(seconds(3));
  asker_.client.cancel(id, bus_.now() + seconds(1));
  bus_.run_for(seconds(1));
  EXPECT_EQ(news_of(id).back(), What::not_ended);
}

TEST_F(ActionPortTest, WithoutServerTheGoalIsUnansweredAtItsDeadlineAndNotBefore) {
  const GoalId id = send(3, 2);
  bus_.run_for(seconds(1.9));
  EXPECT_FALSE(asker_.client.available());
  EXPECT_THAT(news_of(id), IsEmpty());
  bus_.run_for(seconds(0.1));
  EXPECT_THAT(news_of(id), ElementsAre(What::unanswered));
}

TEST_F(ActionPortTest, AServerThatIsGoneLeavesTheResultUnanswered) {
  start_server();
  const GoalId id = send(80, 1, 5);
  bus_.run_for(seconds(1.5));
  bus_.run_for(seconds(10));
  EXPECT_EQ(news_of(id).back(), What::unanswered);
}

TEST_F(ActionPortTest, TheStatusToldIsThatOfAllGoalsAlsoToWhoComesLate) {
  start_server();
  const GoalId one = send(2);
  const GoalId other = send(80);
  bus_.run_for(seconds(3));
  SimReader<StatusTopic> late(bus_);
  const auto status = late.take();
  ASSERT_EQ(status.size(), 1U);
  ASSERT_EQ(status[0].status_list().size(), 2U);
  EXPECT_EQ(status[0].status_list()[0].goal_info().goal_id().uuid(), one);
  EXPECT_EQ(status[0].status_list()[0].status(), 4);
  EXPECT_EQ(status[0].status_list()[1].goal_info().goal_id().uuid(), other);
  EXPECT_EQ(status[0].status_list()[1].status(), 2);
  EXPECT_GT(status[0].status_list()[1].goal_info().stamp().sec(), 0);
}

}  // namespace
}  // namespace tocsin
