// SPDX-License-Identifier: Apache-2.0
#include "simulation/invariants.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

const Time t0 = start_time + seconds(10);
const std::string uxv = "uxv";
const std::string link = "link";

TopicEnd end_of_class(TrafficClass traffic_class, bool pausable, bool drops) {
  TopicEnd end;
  end.host = uxv;
  end.process = link;
  end.topic = "thing";
  end.scope = Scope::link;
  end.traffic_class = traffic_class;
  end.pausable = pausable;
  end.drops = drops;
  end.lifespan_s = 5;
  return end;
}

class InvariantsTest : public ::testing::Test {
 protected:
  void write(const TopicEnd& end, Status status) {
    sut_.on_written({end, t0, ++sequence_, 10, nullptr, status});
  }
  void deliver(const TopicEnd& end, std::uint64_t sequence, double age_s) {
    sut_.on_delivered({end, reader_, sequence, sequence, t0, t0, t0 + seconds(age_s), 10, nullptr});
  }
  void gate(bool open) { sut_.on_gate({uxv, link, t0, open}); }
  void move(double speed_mps, double after_command_s) {
    sut_.on_position({uxv, t0, 0, 0, 0, speed_mps, 0, t0 - seconds(after_command_s)});
  }
  void want_velocity(Time at) {
    TopicEnd end;
    end.topic = topic::CmdVel::info.name;
    topic::CmdVel::Message message;
    message.linear().x(0.2);
    sut_.on_written({end, at, 1, 0, &message, Status::ok});
  }
  [[nodiscard]] std::size_t broken() const { return sut_.violations().size(); }

  Invariants sut_;
  TopicEnd reader_;
  std::uint64_t sequence_ = 0;
  TopicEnd critical_ = end_of_class(TrafficClass::critical, false, false);
  TopicEnd low_ = end_of_class(TrafficClass::low, true, true);
  TopicEnd goal_ = end_of_class(TrafficClass::high, true, false);
};

TEST_F(InvariantsTest, CriticalSamplesAreNeverPaused) {
  write(critical_, Status::ok);
  write(low_, Status::paused);
  EXPECT_EQ(broken(), 0U);
  write(critical_, Status::paused);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, NothingPausableGoesThroughAClosedGate) {
  sut_.on_sent({low_, t0, 1, 1, 10});
  gate(false);
  sut_.on_sent({critical_, t0, 1, 1, 10});
  EXPECT_EQ(broken(), 0U);
  sut_.on_sent({low_, t0, 2, 2, 10});
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, WhatTheGateKeptIsSentWhenItOpens) {
  gate(false);
  write(goal_, Status::paused);
  gate(true);
  sut_.on_sent({goal_, t0, 1, sequence_, 10});
  sut_.on_step(t0);
  EXPECT_EQ(broken(), 0U);
}

TEST_F(InvariantsTest, WhatTheGateKeptAndLostIsFound) {
  gate(false);
  write(goal_, Status::paused);
  gate(true);
  sut_.on_step(t0);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, ADyingProcessMayLoseWhatItKept) {
  gate(false);
  write(goal_, Status::paused);
  sut_.on_process({uxv + "/" + link, ProcessEvent::killed, t0, 0});
  gate(true);
  sut_.on_step(t0);
  EXPECT_EQ(broken(), 0U);
}

TEST_F(InvariantsTest, SamplesComeInOrderAndOnce) {
  deliver(goal_, 1, 0.1);
  deliver(goal_, 3, 0.1);
  EXPECT_EQ(broken(), 0U);
  deliver(goal_, 3, 0.1);
  deliver(goal_, 2, 0.1);
  EXPECT_EQ(broken(), 2U);
}

TEST_F(InvariantsTest, NothingComesAfterItsLifespan) {
  deliver(goal_, 1, 5);
  EXPECT_EQ(broken(), 0U);
  deliver(goal_, 2, 5.001);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, TheBaseStopsAfterTheLastCommand) {
  want_velocity(t0);
  move(0.3, 1.2);
  move(0, 100);
  EXPECT_EQ(broken(), 0U);
  move(0.3, 1.21);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, TheVehicleStopsWhenNobodyWantsItToMove) {
  want_velocity(t0 - seconds(2));
  move(0.3, 0.02);
  EXPECT_EQ(broken(), 0U);
  sut_.on_position({uxv, t0 + seconds(0.01), 0, 0, 0, 0.3, 0, t0});
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, NetworkQualityIsInItsRange) {
  TopicEnd end;
  end.topic = topic::NetworkQuality::info.name;
  topic::NetworkQuality::Message message;
  message.per_percent(100);
  message.quality_percent(std::numeric_limits<float>::quiet_NaN());
  sut_.on_written({end, t0, 1, 0, &message, Status::ok});
  EXPECT_EQ(broken(), 0U);
  message.per_percent(100.5F);
  sut_.on_written({end, t0, 2, 0, &message, Status::ok});
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, NoComponentThrows) {
  sut_.on_failure("navigator", "bad", t0);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, TheMissionIsOverAndDone) {
  Outcome outcome;
  outcome.exit_code = 0;
  sut_.on_end(outcome);
  EXPECT_EQ(broken(), 0U);
  outcome.exit_code = 1;
  sut_.on_end(outcome);
  EXPECT_EQ(broken(), 1U);
  outcome.exit_code.reset();
  sut_.on_end(outcome);
  EXPECT_EQ(broken(), 2U);
}

}  // namespace
}  // namespace tocsin::simulation
