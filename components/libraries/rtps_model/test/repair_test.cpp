// SPDX-License-Identifier: Apache-2.0
#include "writer_fixture.hpp"

namespace tocsin::rtps {
namespace {

// Repair.

TEST_F(ReliableWriterTest, ResendsARequestedSampleToWhoAskedForIt) {
  make(keep_last(5), {reader, other});
  for (int i = 0; i < 3; ++i) write();
  sent_.clear();
  acknowledge(reader, 2, {2}, 0.1);
  EXPECT_EQ(sent_.data(reader), Sequences{2});
  EXPECT_TRUE(sent_.data(other).empty());
}

TEST_F(ReliableWriterTest, AnswersAfterTheDelayAndOnceForAllRequestsMeanwhile) {
  WriterSettings settings = keep_last(5);
  settings.nack_response_delay = seconds(0.05);
  make(settings);
  write();
  write();
  sent_.clear();
  acknowledge(reader, 1, {1}, 0.100);
  acknowledge(reader, 1, {1, 2}, 0.120);
  run_until(0.149);
  EXPECT_TRUE(sent_.data(reader).empty());
  run_until(0.150);
  EXPECT_EQ(sent_.data(reader), (Sequences{1, 2}));
  EXPECT_EQ(sent_.all.size(), 1U);  // both in one message
}

TEST_F(ReliableWriterTest, IgnoresRequestsForTheTimeOfSuppression) {
  WriterSettings settings = keep_last(5);
  settings.nack_suppression = seconds(0.05);
  make(settings);
  write();
  sent_.clear();
  run_until(0.049);
  acknowledge(reader, 1, {1}, 0.049);
  EXPECT_TRUE(sent_.data(reader).empty());
  run_until(0.050);
  acknowledge(reader, 1, {1}, 0.050);
  EXPECT_EQ(sent_.data(reader), Sequences{1});
}

TEST_F(ReliableWriterTest, ARequestThatWasSuppressedIsAskedForAgainByHeartbeat) {
  WriterSettings settings = keep_last(5);
  settings.nack_suppression = seconds(0.05);
  make(settings);
  write();
  acknowledge(reader, 1, {1}, 0.01);
  run_until(0.2);
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 1U);
}

TEST_F(ReliableWriterTest, ResendsTheFragmentsThatAreMissing) {
  make(keep_last(1));
  write(5000);
  sent_.clear();
  want_pieces(reader, 1, {2, 4}, 0.1);
  EXPECT_EQ(sent_.fragments(reader), (Fragments{2, 4}));
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 2U);  // and asks again with each
}

TEST_F(ReliableWriterTest, AnOldAnswerCountsForNothing) {
  make(keep_last(5));
  write();
  write();
  sent_.clear();
  acknowledge(reader, 2, {}, 0.1);
  --acknacks_;
  acknowledge(reader, 1, {1}, 0.2);
  EXPECT_TRUE(sent_.data(reader).empty());
}

TEST_F(ReliableWriterTest, AStrangerIsNotAnswered) {
  make(keep_last(5));
  write();
  sent_.clear();
  acknowledge(99, 1, {1}, 0.1);
  EXPECT_TRUE(sent_.all.empty());
}

TEST_F(ReliableWriterTest, WhatReadersOfDifferentProgressLackIsSentOnceToEach) {
  make(keep_last(1), {reader, other});
  write(3000);
  sent_.clear();
  sut_->on_message(reader, message_of({NackFrag{1, {2, 3}, 90}}), at(0.1));
  EXPECT_EQ(sent_.fragments(reader), (Fragments{2, 3}));
  EXPECT_TRUE(sent_.fragments(other).empty());
  // All readers hear the heartbeats, in messages of their own.
  EXPECT_EQ(sent_.parts<Heartbeat>(other).size(), 2U);
}

// Late readers.

TEST_F(ReliableWriterTest, GreetsANewReaderWithAHeartbeat) {
  make(keep_last(5), {});
  write();
  sut_->match(reader, at(1));
  ASSERT_EQ(sent_.all.size(), 1U);
  EXPECT_EQ(last_heartbeat(reader).first, 2U);
  EXPECT_EQ(last_heartbeat(reader).last, 1U);
  EXPECT_EQ(sut_->next_event(), never);
}

TEST_F(ReliableWriterTest, TellsALateReaderByGapThatAVolatileHistoryIsNotForIt) {
  make(keep_last(5), {other});
  write();
  write();
  sut_->match(reader, at(1));
  ASSERT_EQ(sent_.parts<Gap>(reader).size(), 1U);
  EXPECT_EQ(sent_.parts<Gap>(reader)[0].first, 1U);
  EXPECT_EQ(sent_.parts<Gap>(reader)[0].end, 3U);
  EXPECT_TRUE(sent_.data(reader).empty());
  acknowledge(reader, 1, {1, 2}, 1.1);  // the gap was lost
  EXPECT_EQ(sent_.parts<Gap>(reader).size(), 2U);
  EXPECT_TRUE(sent_.data(reader).empty());
}

TEST_F(ReliableWriterTest, FillsTheHoleBeforeTheFirstSampleOfALateReader) {
  make(keep_last(5), {other});
  write();
  write();
  sut_->match(reader, at(1));
  sent_.clear();
  write(100, 1);
  EXPECT_EQ(sent_.data(reader), Sequences{3});
  ASSERT_EQ(sent_.parts<Gap>(reader).size(), 1U);
  EXPECT_EQ(sent_.parts<Gap>(reader)[0].end, 3U);
  EXPECT_TRUE(sent_.parts<Gap>(other).empty());
}

TEST_F(ReliableWriterTest, ALateReaderOfATransientLocalTopicAsksForTheHistory) {
  make(keep_last(5, true), {other});
  write();
  write();
  acknowledge(other, 3, {}, 0);
  sut_->match(reader, at(1));
  EXPECT_TRUE(sent_.data(reader).empty());
  EXPECT_EQ(last_heartbeat(reader).first, 1U);
  acknowledge(reader, 1, {1, 2}, 1.1);
  EXPECT_EQ(sent_.data(reader), (Sequences{1, 2}));
}

TEST_F(ReliableWriterTest, AnswersTheCallOfAReaderThatHasHeardNothing) {
  make(keep_last(5, true), {});
  write();
  sut_->match(reader, at(1));
  sent_.clear();
  acknowledge(reader, 0, {}, 1.07);
  EXPECT_EQ(last_heartbeat(reader).last, 1U);
}

TEST_F(ReliableWriterTest, AReaderThatCallsAgainMayHaveTheHistoryAgain) {
  make(keep_last(5, true));
  write();
  acknowledge(reader, 2, {}, 0.1);
  acknowledge(reader, 0, {}, 1);
  sent_.clear();
  acknowledge(reader, 1, {1}, 1.1);
  EXPECT_EQ(sent_.data(reader), Sequences{1});
}

TEST_F(ReliableWriterTest, WhoLeavesIsNotWaitedFor) {
  make(keep_last(5), {reader, other});
  write();
  acknowledge(reader, 2, {}, 0.1);
  sut_->unmatch(other, at(0.2));
  sut_->unmatch(other, at(0.2));
  EXPECT_FALSE(sut_->find(1));
  sent_.clear();
  write(100, 0.3);
  EXPECT_TRUE(sent_.data(other).empty());
  sut_->unmatch(reader, at(0.4));
  EXPECT_EQ(sut_->next_event(), never);
}

// Behind a flow controller.

class Queue final : public SampleQueue {
 public:
  void add(Sequence sequence, bool resent) override {
    (resent ? resent_ : fresh).push_back(sequence);
  }
  void remove(Sequence sequence) override { removed.push_back(sequence); }
  Sequences fresh;
  Sequences resent_;
  Sequences removed;
};

class QueuedWriterTest : public ::testing::Test {
 protected:
  QueuedWriterTest() { sut_.match(reader, t0); }
  bool deliver(Sequence sequence, std::size_t budget_bytes) {
    sent_.clear();
    ByteBudget budget{budget_bytes};
    MessageGroup group(sent_, &budget);
    return sut_.deliver(sequence, group, at(0.1));
  }
  SentMessages sent_;
  Queue queue_;
  ReliableWriter sut_{keep_last(1), sent_, &queue_};
};

TEST_F(QueuedWriterTest, LeavesTheTimeOfSendingToTheQueue) {
  sent_.clear();
  sut_.write(nullptr, 100, t0);
  EXPECT_TRUE(sent_.all.empty());
  EXPECT_EQ(queue_.fresh, Sequences{1});
  EXPECT_TRUE(deliver(1, 2000));
  EXPECT_EQ(sent_.data(reader), Sequences{1});
}

TEST_F(QueuedWriterTest, GoesOnWithTheNextFragmentWhenTheBudgetWasOver) {
  sut_.write(nullptr, 5000, t0);
  EXPECT_FALSE(deliver(1, 2700));
  EXPECT_EQ(sent_.fragments(reader), (Fragments{1, 2}));
  EXPECT_FALSE(deliver(1, 2700));
  EXPECT_EQ(sent_.fragments(reader), (Fragments{3, 4}));
  EXPECT_TRUE(deliver(1, 2700));
  EXPECT_EQ(sent_.fragments(reader), Fragments{5});
}

TEST_F(QueuedWriterTest, TakesBackWhatIsPushedOut) {
  sut_.write(nullptr, 100, t0);
  sut_.write(nullptr, 100, t0);
  EXPECT_EQ(queue_.removed, Sequences{1});
  EXPECT_TRUE(deliver(1, 2000));
  EXPECT_TRUE(sent_.data(reader).empty());
}

TEST_F(QueuedWriterTest, ARepairIsQueuedAsSuch) {
  sut_.write(nullptr, 100, t0);
  (void)deliver(1, 2000);
  sut_.on_message(reader, message_of({AckNack{1, {1}, 9}}), at(0.2));
  EXPECT_EQ(queue_.resent_, Sequences{1});
}

}  // namespace
}  // namespace tocsin::rtps
