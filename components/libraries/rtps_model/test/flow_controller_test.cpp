// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/flow_controller.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

using Entry = FlowController::Entry;

/// Each delivery is a message of 96 bytes more than its sample, as on the wire with one reader of
/// two; written down as "writer:sequence".
class FlowControllerTest : public ::testing::Test {
 protected:
  FlowController make(Schedule schedule, std::size_t bytes_per_period) {
    return {{schedule, bytes_per_period, std::chrono::milliseconds(10)}, t0};
  }
  bool deliver(const Entry& entry, ByteBudget& budget) {
    if (budget.is_exceeded_by(entry.bytes)) return false;
    budget.sent += entry.bytes + 96;
    sent_ += (sent_.empty() ? "" : " ") + std::to_string(entry.writer) + ":" +
             std::to_string(entry.sequence);
    return true;
  }
  std::string run(FlowController& sut, double s) {
    sent_.clear();
    sut.run(at(s),
            [this](const Entry& entry, ByteBudget& budget) { return deliver(entry, budget); });
    return sent_;
  }
  static Entry small(std::size_t writer, Sequence sequence) { return {writer, sequence, 100, 0}; }
  std::string sent_;
};

TEST_F(FlowControllerTest, SendsAtOnceWhatFitsThePeriodAndTheRestInTheNext) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  for (Sequence i = 1; i <= 5; ++i) sut.add(small(0, i), false);
  EXPECT_EQ(run(sut, 0), "0:1 0:2");  // 2 x 196, and 20 + 100 do not fit 108
  EXPECT_EQ(sut.next_event(), at(0.010));
  EXPECT_EQ(run(sut, 0.0099), "");
  EXPECT_EQ(run(sut, 0.010), "0:3 0:4");
  EXPECT_EQ(run(sut, 0.020), "0:5");
  EXPECT_EQ(sut.next_event(), never);
}

TEST_F(FlowControllerTest, AnIdlePeriodSavesNothing) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  EXPECT_EQ(run(sut, 1.0), "");
  for (Sequence i = 1; i <= 5; ++i) sut.add(small(0, i), false);
  EXPECT_EQ(run(sut, 1.005), "0:1 0:2");
  EXPECT_EQ(sut.next_event(), at(1.010));  // periods follow each other from the start
  EXPECT_EQ(run(sut, 1.010), "0:3 0:4");
}

TEST_F(FlowControllerTest, NewSamplesGoBeforeThoseThatAreSentAgain) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  sut.add(small(0, 1), true);
  sut.add(small(0, 2), false);
  sut.add(small(0, 3), false);
  EXPECT_EQ(run(sut, 0), "0:2 0:3");
  EXPECT_EQ(run(sut, 0.010), "0:1");
}

TEST_F(FlowControllerTest, ASampleWaitsOnce) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  sut.add(small(0, 1), false);
  sut.add(small(0, 1), false);
  sut.add(small(0, 1), true);
  EXPECT_EQ(run(sut, 0), "0:1");
}

TEST_F(FlowControllerTest, ARemovedSampleIsNotSent) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  (void)sut.add_writer({});
  sut.add(small(0, 1), false);
  sut.add(small(1, 1), true);
  sut.remove(0, 1);
  sut.remove(0, 7);
  EXPECT_EQ(run(sut, 0), "1:1");
}

TEST_F(FlowControllerTest, FifoServesWritersInTheOrderOfTheirSamples) {
  FlowController sut = make(Schedule::fifo, 5000);
  (void)sut.add_writer({-10, 0});
  (void)sut.add_writer({10, 0});
  sut.add(small(1, 1), false);
  sut.add(small(0, 1), false);
  sut.add(small(1, 2), false);
  EXPECT_EQ(run(sut, 0), "1:1 0:1 1:2");
}

TEST_F(FlowControllerTest, RoundRobinServesWritersInTurn) {
  FlowController sut = make(Schedule::round_robin, 700);
  for (int i = 0; i < 3; ++i) (void)sut.add_writer({});
  for (Sequence i = 1; i <= 3; ++i) sut.add(small(0, i), false);
  for (Sequence i = 1; i <= 3; ++i) sut.add(small(2, i), false);
  EXPECT_EQ(run(sut, 0), "0:1 2:1 0:2");  // 3 x 196, and the fourth does not fit
  sut.add(small(1, 1), false);
  EXPECT_EQ(run(sut, 0.010), "2:2 0:3 1:1");
  EXPECT_EQ(run(sut, 0.020), "2:3");
}

TEST_F(FlowControllerTest, HighPriorityServesTheLowestNumberFirst) {
  FlowController sut = make(Schedule::high_priority, 5000);
  (void)sut.add_writer({10, 0});
  (void)sut.add_writer({-10, 0});
  (void)sut.add_writer({10, 0});
  sut.add(small(2, 1), false);
  sut.add(small(0, 1), false);
  sut.add(small(1, 1), true);
  EXPECT_EQ(run(sut, 0), "1:1 2:1 0:1");  // those of equal priority share a queue
}

TEST_F(FlowControllerTest, AReservationGoesBeforePriorityUntilItIsUsed) {
  FlowController sut = make(Schedule::priority_with_reservation, 900);
  (void)sut.add_writer({-10, 0});
  (void)sut.add_writer({10, 25});  // 225 bytes: two samples of 100
  for (Sequence i = 1; i <= 4; ++i) sut.add(small(0, i), false);
  for (Sequence i = 1; i <= 4; ++i) sut.add(small(1, i), false);
  EXPECT_EQ(run(sut, 0), "1:1 1:2 0:1 0:2");
  EXPECT_EQ(run(sut, 0.010), "1:3 1:4 0:3 0:4");
}

TEST_F(FlowControllerTest, AReservationOfExactlyASampleIsTooSmall) {
  FlowController sut = make(Schedule::priority_with_reservation, 1000);
  (void)sut.add_writer({-10, 0});
  (void)sut.add_writer({10, 10});
  sut.add(small(0, 1), false);
  sut.add(small(1, 1), false);
  EXPECT_EQ(run(sut, 0), "0:1 1:1");
}

TEST_F(FlowControllerTest, WhatIsHalfSentGoesOnFirst) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  int calls = 0;
  const auto two_periods = [&](const Entry&, ByteBudget& budget) {
    budget.sent = budget.limit;
    return ++calls == 2;
  };
  sut.add({0, 1, 1000, 400}, false);
  sut.add(small(0, 2), false);
  sut.run(at(0), two_periods);
  sut.run(at(0.010), two_periods);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(run(sut, 0.020), "0:2");
}

TEST_F(FlowControllerTest, ABeginNeedsRoomForTheSmallestPieceOnly) {
  FlowController sut = make(Schedule::fifo, 500);
  (void)sut.add_writer({});
  int calls = 0;
  const auto count = [&](const Entry&, ByteBudget&) { return ++calls > 0; };
  sut.add({0, 1, 479, 0}, false);  // 20 + 479 < 500
  sut.add({0, 2, 480, 0}, false);
  sut.run(at(0), count);
  EXPECT_EQ(calls, 1);
  sut.add({0, 3, 400 + 1, 400}, false);
  sut.remove(0, 2);
  sut.run(at(0.010), count);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace tocsin::rtps
