// SPDX-License-Identifier: Apache-2.0
#include "writer_fixture.hpp"

namespace tocsin::rtps {
namespace {

// What is sent at once.

TEST_F(ReliableWriterTest, SendsASampleToEveryReader) {
  make(keep_last(1), {reader, other});
  write();
  EXPECT_EQ(sent_.data(reader), Sequences{1});
  EXPECT_EQ(sent_.data(other), Sequences{1});
  EXPECT_EQ(sent_.all[0].message, sent_.all[1].message);
}

TEST_F(ReliableWriterTest, AHeartbeatRidesOnEverySampleOfDepthOne) {
  make(keep_last(1));
  write();
  EXPECT_EQ(sent_.all.size(), 1U);
  EXPECT_EQ(last_heartbeat(reader).first, 1U);
  EXPECT_EQ(last_heartbeat(reader).last, 1U);
}

TEST_F(ReliableWriterTest, AHeartbeatRidesWhenTheHistoryIsFullAndNotBefore) {
  make(keep_last(3));
  write();
  write();
  EXPECT_TRUE(sent_.parts<Heartbeat>(reader).empty());
  write();
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 1U);
}

TEST_F(ReliableWriterTest, AHeartbeatRidesWhenAReaderLacksWhatIsGone) {
  WriterSettings settings = keep_last(5);
  settings.lifespan = seconds(1);
  make(settings);
  write(100, 0);
  acknowledge(reader, 2, {}, 0.5);
  write(100, 2);
  EXPECT_TRUE(sent_.parts<Heartbeat>(reader).empty());
  write(100, 4);  // sample 2 is gone, and was not acknowledged
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 1U);
}

TEST_F(ReliableWriterTest, NoHeartbeatRidesWhenThatIsSwitchedOff) {
  WriterSettings settings = keep_last(1);
  settings.heartbeat_piggyback = false;
  make(settings);
  write();
  EXPECT_TRUE(sent_.parts<Heartbeat>(reader).empty());
}

TEST_F(ReliableWriterTest, EveryFragmentOfDepthOneBringsAHeartbeat) {
  make(keep_last(1));
  write(3000);
  EXPECT_EQ(sent_.fragments(reader), (Fragments{1, 2, 3}));
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 3U);
  ASSERT_EQ(sent_.all.size(), 3U);
  EXPECT_EQ(sent_.all[0].message->ip_bytes, 1428U);
}

TEST_F(ReliableWriterTest, CutsAboveTheFragmentSizeOnly) {
  make(keep_last(1));
  write(wire::largest_payload);
  EXPECT_EQ(sent_.fragments(reader), Fragments{0});
  write(wire::largest_payload + 1);
  EXPECT_EQ(sent_.fragments(reader), (Fragments{0, 1, 2}));
}

// Periodic heartbeats.

TEST_F(ReliableWriterTest, BeatsWhileASampleIsNotAcknowledged) {
  make(keep_last(5));
  write(100, 1);
  run_until(1.199);
  EXPECT_TRUE(sent_.parts<Heartbeat>(reader).empty());
  run_until(1.2);
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 1U);
  run_until(1.6);
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 3U);
  EXPECT_EQ(last_heartbeat(reader).count, sent_.parts<Heartbeat>(reader).front().count + 2);
}

TEST_F(ReliableWriterTest, IsSilentWhenAllIsAcknowledged) {
  make(keep_last(5));
  write();
  acknowledge(reader, 2, {}, 0.1);
  run_until(10);
  EXPECT_TRUE(sent_.parts<Heartbeat>(reader).empty());
  EXPECT_EQ(sut_->next_event(), never);
}

TEST_F(ReliableWriterTest, ABeatGoesToAllReaders) {
  make(keep_last(5), {reader, other});
  write();
  acknowledge(reader, 2, {}, 0.1);
  run_until(0.2);
  EXPECT_EQ(sent_.parts<Heartbeat>(reader).size(), 1U);
  EXPECT_EQ(sent_.parts<Heartbeat>(other).size(), 1U);
}

TEST_F(ReliableWriterTest, ARunningTimerIsNotPutOffByTheNextSample) {
  make(keep_last(5));
  write(100, 0);
  write(100, 0.15);
  EXPECT_EQ(sut_->next_event(), at(0.2));
}

// History.

TEST_F(ReliableWriterTest, KeepLastPushesTheOldestSampleOut) {
  make(keep_last(2));
  for (int i = 0; i < 3; ++i) write();
  EXPECT_FALSE(sut_->find(1));
  EXPECT_TRUE(sut_->find(2));
  EXPECT_FALSE(sut_->find(4));
  EXPECT_EQ(last_heartbeat(reader).first, 2U);
}

TEST_F(ReliableWriterTest, AVolatileWriterForgetsWhatAllHaveAcknowledged) {
  make(keep_last(5), {reader, other});
  write();
  acknowledge(reader, 2, {}, 0);
  EXPECT_TRUE(sut_->find(1));
  acknowledge(other, 2, {}, 0);
  EXPECT_FALSE(sut_->find(1));
}

TEST_F(ReliableWriterTest, ATransientLocalWriterKeepsIt) {
  make(keep_last(5, true));
  write();
  acknowledge(reader, 2, {}, 0);
  EXPECT_TRUE(sut_->find(1));
}

TEST_F(ReliableWriterTest, WithoutReadersAVolatileWriterKeepsNothing) {
  make(keep_last(5), {});
  write();
  EXPECT_FALSE(sut_->find(1));
  EXPECT_EQ(sut_->next_event(), never);
}

TEST_F(ReliableWriterTest, AFullKeepAllHistoryHasRoomWhenTheFirstSampleIsAcknowledged) {
  WriterSettings settings = keep_last(2, true);
  settings.keep_all = true;
  make(settings);
  write();
  EXPECT_TRUE(sut_->has_room(t0));
  write();
  EXPECT_FALSE(sut_->has_room(t0));
  acknowledge(reader, 2, {}, 0);
  EXPECT_TRUE(sut_->has_room(t0));
  EXPECT_FALSE(sut_->find(1));
}

TEST_F(ReliableWriterTest, ASampleIsForgottenAfterItsLifespan) {
  WriterSettings settings = keep_last(5);
  settings.lifespan = seconds(1);
  make(settings);
  write();
  acknowledge(reader, 1, {1}, 1.0);
  EXPECT_EQ(sent_.data(reader).size(), 2U);
  acknowledge(reader, 1, {1}, 1.001);
  EXPECT_EQ(sent_.data(reader).size(), 2U);
  run_until(10);
  EXPECT_EQ(sut_->next_event(), never);
}

TEST_F(ReliableWriterTest, AClearedWriterIsSilent) {
  make(keep_last(5));
  write();
  sut_->clear();
  sent_.clear();
  acknowledge(reader, 1, {1}, 0.1);
  run_until(10);
  EXPECT_TRUE(sent_.all.empty());
  write(100, 11);
  EXPECT_EQ(sent_.data(reader), Sequences{2});
}

}  // namespace
}  // namespace tocsin::rtps
