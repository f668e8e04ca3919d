// SPDX-License-Identifier: Apache-2.0
#include "runtime/port.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

class Reading : public Component {
 public:
  explicit Reading(Context& context) : Component(context) {}
  void tick(Time) override {}
  Input<topic::MissionStatus> state{*this};
  Input<topic::Goal> command{*this};
};

/// Looks at its input when it is ticked for another reason.
class Polling : public Component {
 public:
  explicit Polling(Context& context) : Component(context) {}
  void tick(Time) override {}
  Input<topic::Goal> command{*this, WakeMode::time_triggered};
};

/// Counts the calls.
class CountingWaker : public Waker {
 public:
  void wake() override { ++calls; }
  int calls = 0;
};

class PortTest : public ::testing::Test {
 protected:
  void publish_goal() { bus_.publish<topic::Goal>({}); }
  SimBus bus_;
  Context context_{bus_, "reading", Role::uxv};
  Reading sut_{context_};
};

TEST_F(PortTest, CountsWhatCameAndWhatItHadToDrop) {
  for (int i = 0; i < 64; ++i) publish_goal();
  EXPECT_EQ(sut_.command.health().dropped, 0U);
  publish_goal();
  const PortHealth health = sut_.command.health();
  EXPECT_EQ(health.received, 65U);
  EXPECT_EQ(health.dropped, 1U);
  EXPECT_EQ(health.depth, 64U);
  EXPECT_EQ(health.last, bus_.now());
}

TEST_F(PortTest, TakingEmptiesTheQueueAndKeepsTheCount) {
  publish_goal();
  EXPECT_NE(sut_.command.take(), nullptr);
  EXPECT_EQ(sut_.command.take(), nullptr);
  EXPECT_EQ(sut_.command.health().depth, 0U);
  EXPECT_EQ(sut_.command.health().received, 1U);
}

TEST_F(PortTest, ASampleAsksForATick) {
  sut_.schedule().begin_tick(bus_.now());
  publish_goal();
  EXPECT_TRUE(sut_.schedule().input_pending);
}

TEST_F(PortTest, ASampleThatWaitsAsksForNoTickAndIsThereInTheNext) {
  Polling sut(context_);
  CountingWaker waker;
  sut.schedule().set_waker(&waker);
  sut.schedule().begin_tick(bus_.now());
  EXPECT_FALSE(sut.command.has_sample());
  publish_goal();
  EXPECT_FALSE(sut.schedule().input_pending);
  EXPECT_EQ(waker.calls, 0);
  sut.schedule().begin_tick(bus_.now());
  EXPECT_TRUE(sut.command.has_sample());
  EXPECT_NE(sut.command.take(), nullptr);
  sut.schedule().set_waker(nullptr);
}

TEST_F(PortTest, AComponentTellsTheAccountOfAllItsInputs) {
  const auto all = sut_.port_health();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].topic, "mission_status");
  EXPECT_EQ(all[1].topic, "goal");
  EXPECT_EQ(all[1].last, Time{});
}

TEST_F(PortTest, ADeafComponentHearsNothingAndForgetsWhatWaited) {
  publish_goal();
  sut_.listen(false);
  publish_goal();
  EXPECT_EQ(sut_.command.take(), nullptr);
  EXPECT_EQ(sut_.command.health().received, 1U);
}

TEST_F(PortTest, ListeningAgainGivesTheLastStateButNoOldCommand) {
  sut_.listen(false);
  publish_goal();
  bus_.publish<topic::MissionStatus>({});
  sut_.listen(true);
  EXPECT_NE(sut_.state.take(), nullptr);
  EXPECT_EQ(sut_.command.take(), nullptr);
}

TEST_F(PortTest, TakingTheMessageOfAnEmptyQueueGivesNull) {
  EXPECT_EQ(sut_.command.take_message(), nullptr);
  publish_goal();
  publish_goal();
  EXPECT_NE(sut_.command.take_message(), nullptr);
  EXPECT_TRUE(sut_.command.take_sample());
  EXPECT_EQ(sut_.command.take_message(), nullptr);
  EXPECT_FALSE(sut_.command.take_sample());
  publish_goal();
  EXPECT_TRUE(sut_.command.take_sample());
}

TEST_F(PortTest, AnOutputIsWantedAsLongAsSomebodyReadsIt) {
  Output<topic::Goal> goals(sut_);
  EXPECT_TRUE(goals.wanted());
  sut_.listen(false);
  EXPECT_FALSE(goals.wanted());
}

TEST_F(PortTest, AnOutputThatLateReadersGetIsAlwaysWanted) {
  Output<topic::MissionStatus> states(sut_);
  sut_.listen(false);
  EXPECT_TRUE(states.wanted());
}

TEST_F(PortTest, WakesOnceForSeveralInputsUntilTheNextTick) {
  CountingWaker waker;
  sut_.schedule().set_waker(&waker);
  publish_goal();
  publish_goal();
  EXPECT_EQ(waker.calls, 1);
  sut_.schedule().begin_tick(bus_.now());
  publish_goal();
  EXPECT_EQ(waker.calls, 2);
  sut_.schedule().set_waker(nullptr);
}

}  // namespace
}  // namespace tocsin
