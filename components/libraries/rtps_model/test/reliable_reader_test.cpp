// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reliable_reader.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

using Sequences = std::vector<Sequence>;
using Fragments = std::vector<Fragment>;

constexpr EndId writer = 7;
constexpr EndId other = 8;

class ReliableReaderTest : public ::testing::Test {
 protected:
  /// A reader of depth `depth` that has heard of an empty history.
  ReliableReader& make(std::size_t depth, double response_delay_s = 0, std::size_t more_room = 1) {
    ReaderSettings settings;
    settings.depth = depth;
    settings.room = depth + more_room;
    settings.heartbeat_response_delay = seconds(response_delay_s);
    sut_.emplace(settings, sent_, [this](EndId from, const SamplePtr& sample) {
      (from == writer ? got_ : got_of_other_).push_back(sample->sequence);
    });
    sut_->match(writer, t0);
    beat(1, 0, 0);
    run_until(0.5);
    sent_.clear();
    return *sut_;
  }
  void take(const std::vector<Submessage>& parts, double s, EndId from = writer) {
    sut_->on_message(from, message_of(parts), at(s));
  }
  void data(Sequence sequence, double s, EndId from = writer) {
    take({Data{sample_of(sequence, 100, at(s)), 0}}, s, from);
  }
  void piece(Sequence sequence, Fragment fragment, double s) {
    take({Data{large(sequence), fragment}}, s);
  }
  Heartbeat heartbeat(Sequence first, Sequence last) { return {first, last, ++heartbeats_}; }
  void beat(Sequence first, Sequence last, double s) { take({heartbeat(first, last)}, s); }
  static SamplePtr large(Sequence sequence) {
    return sample_of(sequence, 3000, at(static_cast<double>(sequence)));
  }
  void run_until(double s) {
    while (sut_->next_event() <= at(s)) sut_->on_time(sut_->next_event());
  }
  [[nodiscard]] AckNack answer() const { return sent_.parts<AckNack>(writer).back(); }
  SentMessages sent_;
  std::optional<ReliableReader> sut_;
  Sequences got_;
  Sequences got_of_other_;
  std::uint32_t heartbeats_ = 0;
};

TEST_F(ReliableReaderTest, GivesSamplesAtOnceInOrder) {
  make(5);
  data(1, 1);
  data(2, 1);
  data(2, 1);  // twice on the air
  EXPECT_EQ(got_, (Sequences{1, 2}));
  EXPECT_TRUE(sent_.all.empty());
}

TEST_F(ReliableReaderTest, WaitsForAMissingSample) {
  make(5);
  data(2, 1);
  EXPECT_TRUE(got_.empty());
  data(1, 2);
  EXPECT_EQ(got_, (Sequences{1, 2}));
}

TEST_F(ReliableReaderTest, AnswersAHeartbeatAtOnceWithWhatItLacks) {
  make(5);
  data(2, 1);
  beat(1, 3, 1);
  EXPECT_EQ(answer().base, 1U);
  EXPECT_EQ(answer().missing, (Sequences{1, 3}));
  EXPECT_EQ(sent_.all.size(), 1U);
}

TEST_F(ReliableReaderTest, AcknowledgesWhenItLacksNothing) {
  make(5);
  data(1, 1);
  beat(1, 1, 1);
  EXPECT_EQ(answer().base, 2U);
  EXPECT_TRUE(answer().missing.empty());
}

TEST_F(ReliableReaderTest, AnswersAfterItsDelayAndOnceForAllHeartbeatsMeanwhile) {
  make(5, 0.05);
  beat(1, 1, 1.00);
  beat(1, 2, 1.04);
  run_until(1.049);
  EXPECT_TRUE(sent_.all.empty());
  run_until(1.050);
  EXPECT_EQ(sent_.all.size(), 1U);
  EXPECT_EQ(answer().missing, (Sequences{1, 2}));
}

TEST_F(ReliableReaderTest, AnOldHeartbeatCountsForNothing) {
  make(5);
  take({Heartbeat{1, 9, heartbeats_}}, 1);
  EXPECT_TRUE(sent_.all.empty());
}

TEST_F(ReliableReaderTest, GivesUpWhatTheHistoryNoLongerHas) {
  make(5);
  data(2, 1);
  data(4, 1);
  beat(4, 4, 1.1);
  EXPECT_EQ(got_, (Sequences{2, 4}));
  EXPECT_EQ(answer().base, 5U);
}

TEST_F(ReliableReaderTest, GivesUpWhatAGapNames) {
  make(5);
  data(3, 1);
  data(6, 1);
  take({Gap{1, 3, {4, 5}}}, 1.1);
  EXPECT_EQ(got_, (Sequences{3, 6}));
}

TEST_F(ReliableReaderTest, ADepthOfOneNeedsTheHeartbeatWhenTwoSamplesAreMissing) {
  make(1);
  take({Data{sample_of(3), 0}, heartbeat(3, 3)}, 1);  // no room beside two that may come
  EXPECT_TRUE(got_.empty());
  EXPECT_EQ(answer().missing, Sequences{3});
  data(3, 1.1);
  EXPECT_EQ(got_, Sequences{3});
}

TEST_F(ReliableReaderTest, ADepthOfOneBearsOneMissingSample) {
  make(1);
  take({Data{sample_of(2), 0}, heartbeat(2, 2)}, 1);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(ReliableReaderTest, AsksForTheMissingPiecesOfASampleThatHasBegun) {
  make(1);
  piece(1, 1, 1);
  beat(1, 1, 1);
  const auto nacks = sent_.parts<NackFrag>(writer);
  ASSERT_EQ(nacks.size(), 1U);
  EXPECT_EQ(nacks[0].missing, (Fragments{2, 3}));
  EXPECT_TRUE(answer().missing.empty());
  EXPECT_EQ(sent_.all.size(), 1U);  // both in one message
}

TEST_F(ReliableReaderTest, EveryFragmentWithAHeartbeatIsAnswered) {
  make(1);
  for (const Fragment fragment : {1, 2, 3}) {
    take({Data{large(1), fragment}, heartbeat(1, 1)}, 1);
  }
  EXPECT_EQ(got_, Sequences{1});
  EXPECT_EQ(sent_.parts<AckNack>(writer).size(), 3U);
  EXPECT_EQ(sent_.parts<NackFrag>(writer).size(), 2U);
  EXPECT_EQ(answer().base, 2U);
}

TEST_F(ReliableReaderTest, ASampleOfWhichNothingCameIsAskedForWhole) {
  make(1);
  beat(1, 1, 1);
  EXPECT_TRUE(sent_.parts<NackFrag>(writer).empty());
  EXPECT_EQ(answer().missing, Sequences{1});
}

TEST_F(ReliableReaderTest, ANewerSampleOfWhichPiecesComeNeedsTheHeartbeatToReplaceAnUnfinishedOne) {
  make(1);
  piece(1, 1, 1);
  take({Data{large(2), 1}, heartbeat(2, 2)}, 2);  // refused: one is missing, one is kept
  EXPECT_EQ(answer().missing, Sequences{2});
  for (const Fragment fragment : {1, 2, 3}) piece(2, fragment, 2.1);
  EXPECT_EQ(got_, Sequences{2});
}

TEST_F(ReliableReaderTest, WithMoreRoomTheOldestUnfinishedSampleIsDroppedForGood) {
  make(2, 0, 10);
  piece(1, 1, 1);
  data(2, 2);
  data(3, 3);  // makes room by sample 1
  EXPECT_EQ(got_, (Sequences{2, 3}));
  beat(1, 3, 3);
  EXPECT_TRUE(answer().missing.empty());
  EXPECT_TRUE(sent_.parts<NackFrag>(writer).empty());
}

TEST_F(ReliableReaderTest, TellsWritersApart) {
  make(5);
  sut_->match(other, t0);
  data(1, 1);
  data(1, 1, other);
  data(3, 1, other);
  EXPECT_EQ(got_, Sequences{1});
  EXPECT_EQ(got_of_other_, Sequences{1});
  sut_->unmatch(other);
  data(2, 1, other);
  EXPECT_EQ(got_of_other_, Sequences{1});
}

TEST_F(ReliableReaderTest, CallsAWriterUntilItHearsAHeartbeat) {
  ReliableReader sut({}, sent_, [](EndId, const SamplePtr&) {});
  sut.match(writer, t0);
  EXPECT_EQ(sut.next_event(), at(0.07));
  sut.on_time(at(0.07));
  sut.on_time(at(0.14));
  ASSERT_EQ(sent_.parts<AckNack>(writer).size(), 2U);
  EXPECT_EQ(answer().base, 0U);
  sut.on_message(writer, message_of({Heartbeat{1, 0, 1}}), at(0.15));
  EXPECT_EQ(answer().base, 1U);
  sut.on_time(at(0.21));
  EXPECT_EQ(sent_.parts<AckNack>(writer).size(), 3U);
  EXPECT_EQ(sut.next_event(), never);
}

}  // namespace
}  // namespace tocsin::rtps
