// SPDX-License-Identifier: Apache-2.0
#include "rtps_fixture.hpp"

namespace tocsin::simulation {
namespace {

TEST_F(RtpsTest, SampleArrivesAfterTheDelayOfTheLink) {
  connect(best_effort());
  write();
  EXPECT_TRUE(got_.empty());
  run_until(1);
  EXPECT_EQ(got_, Sequences{1});
  EXPECT_EQ(got_at_, start_time + seconds(0.5 + delay_s));
}

TEST_F(RtpsTest, BestEffortSampleOfADeadLinkIsLost) {
  connect(best_effort());
  run_until(11);
  write();
  run_until(30);
  write();
  run_until(31);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, BestEffortCostsOnePacketPerSample) {
  connect(best_effort());
  write(5);
  run_until(9);
  EXPECT_EQ(pushed(), 5U);
}

TEST_F(RtpsTest, ReliableSampleOfADeadLinkIsRepaired) {
  connect(reliable(1));
  run_until(11);
  write();
  run_until(14.9);
  EXPECT_TRUE(got_.empty());
  run_until(15.5);
  EXPECT_EQ(got_, Sequences{1});
}

TEST_F(RtpsTest, RepairGivesWhatTheHistoryHoldsInOrder) {
  connect(reliable(3));
  run_until(11);
  write(5);
  run_until(16);
  EXPECT_EQ(got_, (Sequences{3, 4, 5}));
}

TEST_F(RtpsTest, KeepLastOneRepairsTheNewestOnly) {
  connect(reliable(1));
  run_until(11);
  write(3);
  run_until(16);
  EXPECT_EQ(got_, Sequences{3});
}

TEST_F(RtpsTest, ReliableReaderWaitsForEarlierSamples) {
  connect(reliable(10));
  run_until(14.99);
  write();  // lost
  run_until(15.01);
  write();  // arrives before the first is repaired
  run_until(15.1);
  EXPECT_TRUE(got_.empty());
  run_until(16);
  EXPECT_EQ(got_, (Sequences{1, 2}));
}

TEST_F(RtpsTest, ReliabilityCostsOneAnswerWhenNothingIsLost) {
  connect(reliable(1));
  write();
  run_until(9);
  EXPECT_EQ(pushed(), 2U);  // the heartbeat rides on the sample
}

TEST_F(RtpsTest, HeartbeatsGoOnWhileNobodyAnswers) {
  connect(reliable(1));
  run_until(11);
  write();
  run_until(12.1);
  EXPECT_EQ(pushed(), 6U);  // the sample and one heartbeat each 0.2 s
}

TEST_F(RtpsTest, SampleBeyondItsLifespanIsNotRepaired) {
  QosProfile qos = reliable(1);
  qos.lifespan_s = 2;
  connect(qos);
  run_until(11);
  write();
  run_until(13.5);
  const std::uint64_t packets = link_->pushed();
  run_until(20);
  EXPECT_TRUE(got_.empty());
  EXPECT_EQ(link_->pushed(), packets);
}

TEST_F(RtpsTest, SampleWithinItsLifespanIsRepaired) {
  QosProfile qos = reliable(1);
  qos.lifespan_s = 2;
  connect(qos);
  run_until(14);
  write();
  run_until(20);
  EXPECT_EQ(got_, Sequences{1});
}

TEST_F(RtpsTest, SampleThatArrivesAfterItsLifespanIsDropped) {
  QosProfile qos = best_effort();
  qos.lifespan_s = delay_s / 2;
  connect(qos);
  write();
  run_until(1);
  EXPECT_TRUE(got_.empty());
}

TEST_F(RtpsTest, SilencedWriterSendsNeitherDataNorHeartbeat) {
  connect(reliable(1));
  run_until(11);
  write();
  writer_->silence();
  const std::uint64_t packets = link_->pushed();
  run_until(30);
  EXPECT_EQ(link_->pushed(), packets);
  EXPECT_TRUE(got_.empty());
}

TEST_F(RtpsTest, WriterThatWasSilencedGoesOnWithTheNextSample) {
  connect(reliable(1));
  run_until(11);
  write();
  writer_->silence();
  run_until(16);
  write();
  run_until(17);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, LateReaderGetsTheLastStateRepairedWhenLost) {
  use(state());
  write(2);
  run_until(11);
  writer_->match(*reader_);
  run_until(14);
  EXPECT_TRUE(got_.empty());
  run_until(16);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, LateReaderOfAVolatileTopicGetsNewSamplesOnly) {
  use(reliable(1));
  write();
  run_until(1);
  writer_->match(*reader_);
  run_until(2);
  EXPECT_TRUE(got_.empty());
  write();
  run_until(3);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(RtpsTest, AReaderCallsAWriterThatItDoesNotHear) {
  use(reliable(1));
  run_until(11);
  writer_->match(*reader_);
  run_until(12.01);
  EXPECT_EQ(link_->pushed(), 1U + 14U);  // the greeting, and a call each 70 ms
}

TEST_F(RtpsTest, AReaderForgetsADeadWriterWhenItsLeaseIsOver) {
  use(reliable(1));
  run_until(11);
  writer_->match(*reader_);
  writer_->die();
  run_until(71.5);
  const std::uint64_t packets = link_->pushed();
  run_until(80);
  EXPECT_EQ(link_->pushed(), packets);
}

TEST_F(RtpsTest, ADeadReaderIsSentNothing) {
  connect(reliable(1));
  reader_->die();
  write();
  run_until(5);
  EXPECT_EQ(pushed(), 0U);
}

TEST_F(RtpsTest, ADeadReaderOfABestEffortTopicIsSentNothing) {
  connect(best_effort());
  reader_->die();
  write();
  run_until(5);
  EXPECT_EQ(pushed(), 0U);
}

}  // namespace
}  // namespace tocsin::simulation
