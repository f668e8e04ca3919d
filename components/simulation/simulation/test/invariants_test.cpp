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
  void write(const TopicEnd& end) { sut_.on_written({end, t0, ++sequence_, 10, nullptr}); }
  void send(const TopicEnd& end, std::uint64_t written) {
    sut_.on_sent({end, t0, ++sent_, written, 10});
  }
  /// The host's router does what routers do.
  void begin_to_send() { send(low_, 0); }
  void step(double after_s) { sut_.on_step(t0 + seconds(after_s)); }
  void deliver(const TopicEnd& end, std::uint64_t sequence, double age_s) {
    sut_.on_delivered({end, reader_, sequence, sequence, t0, t0, t0 + seconds(age_s), 10, nullptr});
  }
  void gate(GateEvent event, double after_s = 0) {
    sut_.on_gate({uxv, t0 + seconds(after_s), event});
  }
  void move(double speed_mps, double after_command_s) {
    sut_.on_position({uxv, t0, 0, 0, 0, speed_mps, 0, t0 - seconds(after_command_s)});
  }
  void want_velocity(Time at) {
    TopicEnd end;
    end.topic = topic::CmdVel::info.name;
    topic::CmdVel::Message message;
    message.linear().x(0.2);
    sut_.on_written({end, at, 1, 0, &message});
  }
  void report_stop(bool stands, Time at) {
    TopicEnd end;
    end.topic = topic::LinkStop::info.name;
    topic::LinkStop::Message message;
    message.stands(stands);
    sut_.on_written({end, at, 1, 0, &message});
  }
  /// Moves, or was told to, so long after t0.
  void be_at(double after_s, double speed_mps, bool commanded_to_stand) {
    const Time now = t0 + seconds(after_s);
    want_velocity(now);
    sut_.on_position({uxv, now, 0, 0, 0, speed_mps, 0, now, commanded_to_stand});
  }
  [[nodiscard]] std::size_t broken() const { return sut_.violations().size(); }

  Invariants sut_;
  TopicEnd reader_;
  std::uint64_t sequence_ = 0;
  std::uint64_t sent_ = 0;
  TopicEnd critical_ = end_of_class(TrafficClass::critical, false, false);
  TopicEnd low_ = end_of_class(TrafficClass::low, true, true);
  TopicEnd goal_ = end_of_class(TrafficClass::high, true, false);
};

TEST_F(InvariantsTest, OneThatIsOlderThanWhatCameCountsOnlyWhereAllCount) {
  TopicEnd all = end_of_class(TrafficClass::low, true, true);
  all.keeps_one = false;
  for (const std::uint64_t sequence : {1, 3, 2, 4}) deliver(all, sequence, 0.1);
  EXPECT_TRUE(sut_.violations().empty());
  deliver(all, 3, 0.1);
  EXPECT_EQ(sut_.violations().size(), 1U) << "twice";
  for (const std::uint64_t sequence : {1, 3, 2}) deliver(low_, sequence, 0.1);
  EXPECT_EQ(sut_.violations().size(), 2U) << "an old state";
}

TEST_F(InvariantsTest, CriticalSamplesAreSoonOnTheRadio) {
  begin_to_send();
  write(critical_);
  step(0.5);
  EXPECT_EQ(broken(), 0U);
  step(0.6);
  EXPECT_EQ(broken(), 1U);
  step(2);
  EXPECT_EQ(broken(), 1U) << "told once";
}

TEST_F(InvariantsTest, ANewerSampleButNoRepairMayGoInThePlaceOfOneThatWaits) {
  for (const bool newer : {true, false}) {
    sut_ = Invariants();
    begin_to_send();
    write(critical_);
    if (newer) write(critical_);
    send(critical_, newer ? sequence_ : sequence_ - 1);
    step(1);
    EXPECT_EQ(broken(), newer ? 0U : 1U);
  }
}

TEST_F(InvariantsTest, BulkMayWaitAndAHostWithoutARouterSendsNothing) {
  write(critical_);
  begin_to_send();
  write(low_);
  step(1);
  EXPECT_EQ(broken(), 0U);
}

TEST_F(InvariantsTest, NothingPausableGoesThroughAClosedGate) {
  send(low_, 1);
  gate(GateEvent::closed);
  send(critical_, 1);
  EXPECT_EQ(broken(), 0U);
  send(low_, 2);
  EXPECT_EQ(broken(), 1U);
  gate(GateEvent::opened);
  send(low_, 3);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, WhatTheGateKeptIsSentWhenItOpensUnlessItsLifespanIsOver) {
  struct {
    double opened_s;
    bool sent;
    std::size_t broken;
  } const rows[] = {{4, true, 0}, {4, false, 1}, {5.1, false, 0}};
  for (const auto& [opened_s, sent, expected] : rows) {
    sut_ = Invariants();
    begin_to_send();
    gate(GateEvent::closed);
    write(goal_);
    gate(GateEvent::opened, opened_s);
    if (sent) send(goal_, sequence_);
    step(opened_s + 0.5);
    EXPECT_EQ(broken(), 0U) << opened_s;
    step(opened_s + 0.6);
    EXPECT_EQ(broken(), expected) << opened_s;
  }
}

TEST_F(InvariantsTest, ADyingWriterOrRouterMayLoseWhatWaits) {
  begin_to_send();
  write(critical_);
  sut_.on_process({uxv + "/" + link, ProcessEvent::killed, t0, 0});
  write(critical_);
  gate(GateEvent::gone);
  step(1);
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

TEST_F(InvariantsTest, TheBaseIsCommandedToStandHalfASecondAfterAStop) {
  report_stop(true, t0);
  be_at(0.5, 0.3, false);
  EXPECT_EQ(broken(), 0U);
  report_stop(true, t0 + seconds(0.5));
  be_at(0.51, 0.3, false);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, TheBaseRestsSoonAfterAStop) {
  report_stop(true, t0);
  be_at(1.7, 0.3, true);
  EXPECT_EQ(broken(), 0U);
  be_at(1.71, 0.3, true);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, ALocalWriterStopsTheBaseUntilItReleases) {
  TopicEnd button;
  button.topic = topic::EmergencyStop::info.name;
  topic::EmergencyStop::Message message;
  message.data(true);
  sut_.on_written({button, t0, 1, 0, &message});
  be_at(0.6, 0.3, false);
  EXPECT_EQ(broken(), 1U);
  message.data(false);
  sut_.on_written({button, t0, 2, 0, &message});
  be_at(0.7, 0.3, false);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, ARouterThatFallsSilentIsAStop) {
  report_stop(false, t0);
  be_at(1.5, 0.3, false);
  EXPECT_EQ(broken(), 0U);
  be_at(1.51, 0.3, false);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, ADriverThatIsStartedAgainHasItsTimeToStand) {
  be_at(0, 0, true);
  report_stop(true, t0);
  sut_.on_process({"uxv/drive", ProcessEvent::started, t0 + seconds(3), 0});
  be_at(3.5, 0.3, false);
  EXPECT_EQ(broken(), 0U);
  be_at(3.51, 0.3, false);
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, NetworkQualityIsInItsRange) {
  TopicEnd end;
  end.topic = topic::NetworkQuality::info.name;
  topic::NetworkQuality::Message message;
  message.per_percent(100);
  message.quality_percent(std::numeric_limits<float>::quiet_NaN());
  sut_.on_written({end, t0, 1, 0, &message});
  EXPECT_EQ(broken(), 0U);
  message.per_percent(100.5F);
  sut_.on_written({end, t0, 2, 0, &message});
  EXPECT_EQ(broken(), 1U);
}

TEST_F(InvariantsTest, TheMissionIsOverAndDoneAndNoComponentThrows) {
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
  sut_.on_failure("navigator", "bad", t0);
  EXPECT_EQ(broken(), 3U);
}

}  // namespace
}  // namespace tocsin::simulation
