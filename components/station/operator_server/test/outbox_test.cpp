// SPDX-License-Identifier: Apache-2.0
#include "operator_server/outbox.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::foxglove {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

constexpr std::size_t all = 1'000'000;

Frame frame(const std::string& text) { return {Frame::Kind::binary, text}; }

std::vector<std::string> heads(const std::vector<Frame>& frames) {
  std::vector<std::string> texts;
  for (const Frame& one : frames) texts.push_back(one.head);
  return texts;
}

TEST(OutboxTest, ControlGoesBeforeTimeAndTimeBeforeData) {
  Outbox sut({});
  sut.add_data(1, frame("data"));
  sut.set_time(frame("old"));
  sut.set_time(frame("time"));
  sut.add_control(frame("control"));
  EXPECT_THAT(heads(sut.take(all)), ElementsAre("control", "time", "data"));
  EXPECT_TRUE(sut.empty());
  EXPECT_EQ(sut.bytes(), 0U);
}

TEST(OutboxTest, KeepsTheNewestOfEachSubscriptionAndCountsTheRest) {
  Outbox sut({2});
  for (const char* text : {"a1", "a2", "a3", "a4"}) sut.add_data(1, frame(text));
  sut.add_data(2, frame("b1"));
  EXPECT_THAT(heads(sut.take(all)), ElementsAre("a3", "b1", "a4"));
  EXPECT_THAT(sut.take_drops(), ElementsAre(Pair(1, 2)));
  EXPECT_TRUE(sut.take_drops().empty());
}

TEST(OutboxTest, ABigSubscriptionDoesNotStarveASmallOne) {
  Outbox sut({10});
  for (int i = 0; i < 5; ++i) sut.add_data(1, frame(std::string(100, 'x')));
  sut.add_data(2, frame("state"));
  const auto first = heads(sut.take(101));
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[1], "state");
}

TEST(OutboxTest, BeyondItsBytesOnlyTheNewestOfASubscriptionWaits) {
  Outbox sut({10, 250});
  for (int i = 0; i < 3; ++i) sut.add_data(1, frame(std::string(100, 'x')));
  EXPECT_EQ(sut.bytes(), 200U);
  sut.add_data(2, frame(std::string(100, 'y')));
  EXPECT_EQ(sut.bytes(), 300U) << "the only one of its subscription stays";
  EXPECT_THAT(sut.take_drops(), ElementsAre(Pair(1, 1)));
}

TEST(OutboxTest, TakesAboutAsMuchAsIsAskedFor) {
  Outbox sut({10});
  for (int i = 0; i < 4; ++i) sut.add_data(1, frame(std::string(100, 'x')));
  EXPECT_EQ(sut.take(1).size(), 1U);
  EXPECT_EQ(sut.take(101).size(), 2U);
}

TEST(OutboxTest, ForgetsASubscription) {
  Outbox sut({1});
  sut.add_data(1, frame("a"));
  sut.add_data(1, frame("b"));
  sut.add_data(2, frame("c"));
  sut.forget(1);
  EXPECT_TRUE(sut.take_drops().empty());
  EXPECT_THAT(heads(sut.take(all)), ElementsAre("c"));
}

TEST(OutboxTest, MoreControlThanMayWaitIsAnOverflow) {
  Outbox sut({1, 100, 100});
  sut.add_control(frame(std::string(100, 'x')));
  EXPECT_FALSE(sut.overflown());
  sut.add_control(frame("y"));
  EXPECT_TRUE(sut.overflown());
  (void)sut.take(1);
  EXPECT_FALSE(sut.overflown());
}

}  // namespace
}  // namespace tocsin::foxglove
