// SPDX-License-Identifier: Apache-2.0
// Writers that must wait: for room in a history of keep_all, or for a flow controller.
#include "rtps_fixture.hpp"

namespace tocsin::simulation {
namespace {

// A full history of keep_all.

QosProfile keep_all(double max_blocking_s) {
  QosProfile qos;
  qos.history = "keep_all";
  qos.max_samples = 2;
  qos.allocated_samples = 0;
  qos.max_blocking_time_s = max_blocking_s;
  return qos;
}

TEST_F(RtpsTest, ASampleForAFullHistoryWaitsForRoom) {
  connect(keep_all(1));
  run_until(14.5);
  write(3);
  run_until(16);
  EXPECT_EQ(got_, (Sequences{1, 2, 3}));
}

TEST_F(RtpsTest, ASampleForAFullHistoryIsLostWhenTheTimeIsOver) {
  connect(keep_all(1));
  run_until(13);
  write(3);
  run_until(14.1);
  write();  // waits in its turn
  run_until(16);
  EXPECT_EQ(got_, (Sequences{1, 2, 3}));
  write();
  run_until(17);
  EXPECT_EQ(got_, (Sequences{1, 2, 3, 4}));
}

TEST_F(RtpsTest, WhoWritesWhileAnotherSampleWaitsIsRefused) {
  connect(keep_all(1));
  run_until(11);
  write(3);
  EXPECT_EQ(writer_->send(&message_), 0U);
}

TEST_F(RtpsTest, ASampleForAFullHistoryIsRefusedAtOnceWithoutTimeToWait) {
  connect(keep_all(0));
  run_until(11);
  write(2);
  EXPECT_EQ(writer_->send(&message_), 0U);
}

// Flow controllers. A message has 20 bytes, DATA 36 with its time, a destination 16, statistics 60.

constexpr int sample_bytes = 8;  // a bool with its encapsulation, at a multiple of 4

TEST_F(RtpsTest, AFlowControllerSendsWhatFitsEachPeriod) {
  bound(280);
  QosProfile qos = best_effort();
  qos.depth = 10;
  connect(qos);
  write(5);
  EXPECT_EQ(pushed(), 2U) << "2 x " << 20 + 36 + 16 + 60 + sample_bytes;
  run_until(0.5101);
  EXPECT_EQ(pushed(), 4U);
  run_until(1);
  EXPECT_EQ(got_, (Sequences{1, 2, 3, 4, 5}));
}

TEST_F(RtpsTest, ABestEffortWriterKeepsItsDepthForTheFlowController) {
  bound(280);
  QosProfile qos = best_effort();
  qos.depth = 1;
  connect(qos);
  write(5);  // two go at once, the newest waits
  run_until(1);
  EXPECT_EQ(got_, (Sequences{1, 2, 5}));
}

TEST_F(RtpsTest, WhatOutlivesItsLifespanWithTheFlowControllerIsNotSent) {
  bound(280);
  QosProfile qos = best_effort();
  qos.depth = 10;
  qos.lifespan_s = 0.015;
  connect(qos);
  write(7);
  run_until(1);
  EXPECT_EQ(pushed(), 4U);
}

TEST_F(RtpsTest, ASilencedWriterLeavesNothingToTheFlowController) {
  bound(280);
  QosProfile qos = best_effort();
  qos.depth = 10;
  connect(qos);
  write(5);
  writer_->silence();
  run_until(0.7);
  EXPECT_EQ(pushed(), 2U);
}

TEST_F(RtpsTest, ASilencedReliableWriterLeavesNothingToTheFlowController) {
  bound(280);
  connect(reliable(10));
  write(5);
  writer_->silence();
  run_until(0.7);
  EXPECT_EQ(pushed(), 2U);
}

TEST_F(RtpsTest, AReliableWriterBehindAFlowControllerDeliversEverything) {
  bound(280);
  connect(reliable(10));
  run_until(14.9);
  write(8);
  run_until(17);
  EXPECT_EQ(got_, (Sequences{1, 2, 3, 4, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace tocsin::simulation
