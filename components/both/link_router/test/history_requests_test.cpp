// SPDX-License-Identifier: Apache-2.0
#include "link_router/history_requests.hpp"

#include <gmock/gmock.h>

namespace tocsin::router {
namespace {

using sample_log::SampleId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration s = std::chrono::seconds(1);
constexpr std::int64_t second_ns = 1'000'000'000;

SampleId id(std::uint64_t sequence) { return {1, 2, sequence}; }

HistoryRange range(std::uint64_t id, std::int64_t from_s = 10, std::int64_t to_s = 20) {
  return {id, "odom", from_s * second_ns, to_s * second_ns};
}

std::vector<std::uint64_t> ids_of(const std::vector<HistoryRange>& ranges) {
  std::vector<std::uint64_t> ids;
  for (const HistoryRange& one : ranges) ids.push_back(one.id);
  return ids;
}

TEST(StandingRequests, TellEachPeerOnceASecond) {
  StandingRequests sut;
  sut.on_request(range(1), t0);
  EXPECT_THAT(ids_of(sut.take_for("uxv1", t0)), ElementsAre(1));
  EXPECT_THAT(sut.take_for("uxv1", t0 + s - Duration(1)), IsEmpty());
  EXPECT_THAT(ids_of(sut.take_for("uxv2", t0)), ElementsAre(1));
  EXPECT_THAT(ids_of(sut.take_for("uxv1", t0 + s)), ElementsAre(1));
}

TEST(StandingRequests, AreSixteenAtMost) {
  StandingRequests sut;
  for (std::uint64_t i = 1; i <= 20; ++i) sut.on_request(range(i), t0);
  EXPECT_THAT(sut.take_for("uxv", t0), SizeIs(16));
}

class HistoryRequestsTest : public ::testing::Test {
 protected:
  [[nodiscard]] HistoryProgress progress() const { return sut_.progress().at(0); }
  HistoryRequests sut_;
};

TEST_F(HistoryRequestsTest, ARangeIsLookedForOnceAndWhenItIsPast) {
  sut_.on_request(range(1), t0);
  EXPECT_THAT(sut_.take_searches(20 * second_ns), IsEmpty())
      << "its last samples may be on their way";
  EXPECT_THAT(ids_of(sut_.take_searches(21 * second_ns)), ElementsAre(1));
  sut_.on_request(range(1), t0);
  EXPECT_THAT(sut_.take_searches(22 * second_ns), IsEmpty());
  EXPECT_EQ(progress().state, HistoryState::searching);
}

TEST_F(HistoryRequestsTest, IsDoneWhenAllThatWasFoundIsGivenOrGone) {
  sut_.on_request(range(1), t0);
  (void)sut_.take_searches(30 * second_ns);
  sut_.on_found(1, {id(1), id(2), id(3)}, std::nullopt);
  EXPECT_EQ(progress().state, HistoryState::sending);
  sut_.on_delivered({id(1), id(9)});
  sut_.on_delivered({id(1)});
  sut_.on_gone({id(2)});
  EXPECT_EQ(progress().state, HistoryState::sending);
  sut_.on_delivered({id(3)});
  EXPECT_EQ(progress().state, HistoryState::done);
  EXPECT_EQ(progress().found, 3U);
  EXPECT_EQ(progress().delivered, 2U);
  EXPECT_EQ(progress().gone, 1U);
  EXPECT_THAT(sut_.take_searches(40 * second_ns), IsEmpty());
}

TEST_F(HistoryRequestsTest, TheNextPartIsLookedForWhenTheLastIsDelivered) {
  sut_.on_request(range(1), t0);
  (void)sut_.take_searches(30 * second_ns);
  sut_.on_found(1, {id(1)}, 15 * second_ns);
  EXPECT_THAT(sut_.take_searches(30 * second_ns), IsEmpty());
  sut_.on_delivered({id(1)});
  EXPECT_EQ(progress().state, HistoryState::searching);
  const auto next = sut_.take_searches(30 * second_ns);
  ASSERT_THAT(next, SizeIs(1));
  EXPECT_EQ(next[0].from_ns, 15 * second_ns);
  EXPECT_EQ(next[0].to_ns, 20 * second_ns);
  sut_.on_found(1, {id(2)}, std::nullopt);
  sut_.on_delivered({id(2)});
  EXPECT_EQ(progress().state, HistoryState::done);
  EXPECT_EQ(progress().found, 2U);
}

TEST_F(HistoryRequestsTest, WhatNobodyRepeatsIsForgottenAndWhatAnotherWantsStays) {
  sut_.on_request(range(1), t0 + s);
  sut_.on_request(range(2), t0 + 3 * s);
  (void)sut_.take_searches(30 * second_ns);
  sut_.on_found(1, {id(1), id(2)}, std::nullopt);
  sut_.on_found(2, {id(2), id(3)}, std::nullopt);
  EXPECT_THAT(sut_.expire(t0 + s), IsEmpty());
  EXPECT_THAT(sut_.expire(t0 + 2 * s), ElementsAre(id(1)));
  EXPECT_THAT(sut_.progress(), SizeIs(1));
  sut_.on_request(range(2), t0 + 9 * s);
  EXPECT_THAT(sut_.expire(t0 + 9 * s), IsEmpty());
  EXPECT_THAT(sut_.expire(t0 + 10 * s), ElementsAre(id(2), id(3)));
}

TEST_F(HistoryRequestsTest, OneThatIsDoneMakesRoom) {
  for (std::uint64_t i = 1; i <= 64; ++i) EXPECT_TRUE(sut_.on_request(range(i), t0));
  (void)sut_.take_searches(30 * second_ns);
  sut_.on_found(3, {}, std::nullopt);
  EXPECT_TRUE(sut_.on_request(range(65), t0));
  EXPECT_FALSE(sut_.on_request(range(66), t0));
  EXPECT_TRUE(sut_.on_request(range(65), t0)) << "it is there";
}

TEST_F(HistoryRequestsTest, ThoseOfRulesAreToldWhenTheyChangeUntilTheyAreDone) {
  EXPECT_FALSE(sut_.take_rule_requests());
  sut_.on_request(range(1), t0);
  EXPECT_FALSE(sut_.take_rule_requests()) << "somebody's";
  sut_.on_request(RuleRequest{range(2), "stop"}, t0 + s);
  sut_.on_request(RuleRequest{range(3), "stop"}, t0 + 2 * s);
  const auto two = sut_.take_rule_requests();
  ASSERT_TRUE(two);
  ASSERT_THAT(*two, SizeIs(2));
  EXPECT_EQ((*two)[0].range.id, 2U);
  EXPECT_EQ((*two)[0].rule, "stop");
  EXPECT_FALSE(sut_.take_rule_requests());
  sut_.on_request(RuleRequest{range(2), "stop"}, t0 + s);
  EXPECT_FALSE(sut_.take_rule_requests()) << "it stands";
  (void)sut_.take_searches(30 * second_ns);
  sut_.on_found(3, {id(1)}, std::nullopt);
  EXPECT_FALSE(sut_.take_rule_requests()) << "not all of it is delivered";
  sut_.on_delivered({id(1)});
  const auto one = sut_.take_rule_requests();
  ASSERT_TRUE(one);
  ASSERT_THAT(*one, SizeIs(1));
  EXPECT_EQ((*one)[0].range.id, 2U);
  (void)sut_.expire(t0 + 2 * s);
  const auto none = sut_.take_rule_requests();
  ASSERT_TRUE(none);
  EXPECT_THAT(*none, IsEmpty());
}

}  // namespace
}  // namespace tocsin::router
