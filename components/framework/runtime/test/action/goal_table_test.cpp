// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/goal_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Time t0 = Time{std::chrono::hours(1)};

GoalId id(std::uint8_t last) {
  GoalId made{};
  made.back() = last;
  return made;
}

std::vector<GoalId> ids(const CancelAnswer& answer) {
  std::vector<GoalId> all;
  for (const KnownGoal& goal : answer.canceling) all.push_back(goal.id);
  return all;
}

TEST(GoalState, ChangesAsRclActionAllows) {
  using State = GoalState;
  using Event = GoalEvent;
  const std::vector<std::tuple<State, Event, State>> allowed{
      {State::accepted, Event::execute, State::executing},
      {State::accepted, Event::cancel_goal, State::canceling},
      {State::executing, Event::cancel_goal, State::canceling},
      {State::executing, Event::succeed, State::succeeded},
      {State::executing, Event::abort, State::aborted},
      {State::canceling, Event::succeed, State::succeeded},
      {State::canceling, Event::abort, State::aborted},
      {State::canceling, Event::canceled, State::canceled}};
  int found = 0;
  for (int state = 0; state <= 6; ++state) {
    for (const Event event :
         {Event::execute, Event::cancel_goal, Event::succeed, Event::abort, Event::canceled}) {
      const auto next = after(static_cast<State>(state), event);
      if (!next) continue;
      ++found;
      EXPECT_THAT(allowed,
                  ::testing::Contains(std::tuple(static_cast<State>(state), event, *next)));
    }
  }
  EXPECT_EQ(found, 8);
}

TEST(GoalState, HasTheWordsOfRos2) {
  EXPECT_STREQ(to_text(GoalState::unknown), "UNKNOWN");
  EXPECT_STREQ(to_text(GoalState::canceling), "CANCELING");
  EXPECT_STREQ(to_text(GoalState::aborted), "ABORTED");
  EXPECT_STREQ(to_text(static_cast<GoalState>(77)), "UNKNOWN");
  EXPECT_STREQ(to_text(static_cast<GoalState>(-1)), "UNKNOWN");
}

TEST(GoalIdText, IsThirtyTwoDigits) {
  EXPECT_EQ(goal_text(id(0xA5)), "000000000000000000000000000000a5");
}

class GoalTableTest : public ::testing::Test {
 protected:
  /// Works on a goal that was accepted at `ns`.
  void execute(std::uint8_t goal, std::int64_t ns) {
    ASSERT_TRUE(sut_.add(id(goal), ns));
    ASSERT_TRUE(sut_.apply(id(goal), GoalEvent::execute, t0));
  }
  GoalTable sut_{std::chrono::seconds(10)};
};

TEST_F(GoalTableTest, TakesAnIdOnce) {
  execute(1, 5);
  EXPECT_FALSE(sut_.add(id(1), 6));
  ASSERT_EQ(sut_.all().size(), 1U);
  EXPECT_EQ(sut_.all()[0].accepted_ns, 5);
}

TEST_F(GoalTableTest, RefusesWhatTheStateDoesNotAllow) {
  execute(1, 5);
  EXPECT_FALSE(sut_.apply(id(1), GoalEvent::canceled, t0));
  EXPECT_EQ(sut_.state(id(1)), GoalState::executing);
  EXPECT_FALSE(sut_.apply(id(2), GoalEvent::succeed, t0));
  EXPECT_EQ(sut_.state(id(2)), GoalState::unknown);
}

TEST(GoalTableCancel, CancelsThoseThatAreMeantByIdByStampOrByNeither) {
  for (const auto& [request, meant] :
       std::vector<std::pair<CancelRequest, std::vector<GoalId>>>{{{id(2), 0}, {id(2)}},
                                                                  {{}, {id(1), id(2), id(3)}},
                                                                  {{GoalId{}, 6}, {id(1), id(2)}},
                                                                  {{id(3), 5}, {id(1), id(3)}}}) {
    GoalTable sut{std::chrono::seconds(10)};
    for (std::uint8_t goal = 1; goal <= 4; ++goal) {
      ASSERT_TRUE(sut.add(id(goal), 4 + goal));
      ASSERT_TRUE(sut.apply(id(goal), GoalEvent::execute, t0));
    }
    ASSERT_TRUE(sut.apply(id(4), GoalEvent::succeed, t0));
    const auto answer = sut.cancel(request, t0);
    EXPECT_EQ(answer.code, CancelCode::none);
    EXPECT_EQ(ids(answer), meant);
    for (const GoalId& goal : meant) EXPECT_EQ(sut.state(goal), GoalState::canceling);
  }
}

TEST_F(GoalTableTest, SaysWhyNothingIsCanceled) {
  EXPECT_EQ(sut_.cancel({id(1), 0}, t0).code, CancelCode::unknown_goal);
  EXPECT_EQ(sut_.cancel({}, t0).code, CancelCode::none);
  execute(1, 5);
  ASSERT_TRUE(sut_.apply(id(1), GoalEvent::abort, t0));
  EXPECT_EQ(sut_.cancel({id(1), 0}, t0).code, CancelCode::terminated);
  execute(2, 5);
  (void)sut_.cancel({id(2), 0}, t0);
  EXPECT_EQ(sut_.cancel({id(2), 0}, t0).code, CancelCode::terminated);
}

TEST_F(GoalTableTest, ForgetsAGoalSomeTimeAfterItsEndAndNotBefore) {
  execute(1, 5);
  execute(2, 6);
  ASSERT_TRUE(sut_.apply(id(1), GoalEvent::succeed, t0));
  EXPECT_THAT(sut_.forget(t0 + std::chrono::seconds(10)), IsEmpty());
  EXPECT_EQ(sut_.state(id(1)), GoalState::succeeded);
  EXPECT_THAT(sut_.forget(t0 + std::chrono::milliseconds(10001)), ElementsAre(id(1)));
  EXPECT_EQ(sut_.state(id(1)), GoalState::unknown);
  EXPECT_EQ(sut_.state(id(2)), GoalState::executing);
}

}  // namespace
}  // namespace tocsin
