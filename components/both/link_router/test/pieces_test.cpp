// SPDX-License-Identifier: Apache-2.0
// Samples of several packets: their pieces, and the repair of what is lost of them.
#include <random>

#include "link_pair.hpp"

namespace tocsin::router {
namespace {

using Sequences = std::vector<std::uint64_t>;
constexpr std::size_t picture = 30000;
constexpr std::size_t packets = 26;

/// A camera of class low, and something small that the least delay is learned of.
class Pieces : public ::testing::Test {
 protected:
  explicit Pieces(const LinkRouterParams& params = {}) : link(params) {
    link.add(1, rule_of(TrafficClass::low));
    link.add(2, rule_of(TrafficClass::normal));
    link.offer(2, 1);
    link.run(200 * ms);  // no acknowledgement has just been sent
    link.sent.clear();
  }
  /// The radio loses these pieces of a sample, each so many times.
  void lose(std::uint64_t sequence, const std::set<int>& pieces, int times = 1) {
    link.loses = [=, lost = std::map<int, int>{}](const Transmission& one) mutable {
      const bool is_meant =
          one.sample.origin.sequence == sequence && pieces.count(one.piece.index) != 0;
      return one.stream == 1 && is_meant && lost[one.piece.index]++ < times;
    };
  }
  [[nodiscard]] std::vector<int> sent_again() const {
    std::vector<int> pieces;
    for (const Transmission& one : link.sent) {
      if (one.repair) pieces.push_back(one.piece.index);
    }
    return pieces;
  }
  LinkPair link;
};

TEST_F(Pieces, ASampleThatFitsAPacketGoesWhole) {
  link.offer(1, 1, 1192);
  link.run(50 * ms);
  ASSERT_EQ(link.sent.size(), 1U);
  EXPECT_TRUE(link.sent[0].piece.is_whole());
}

TEST_F(Pieces, ALargerOneGoesInOnePieceAPacketAndIsDeliveredOnce) {
  link.offer(1, 1, picture);
  link.run(200 * ms);
  ASSERT_EQ(link.sent.size(), packets);
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < packets; ++i) {
    const Transmission& one = link.sent[i];
    EXPECT_EQ(one.piece, (SamplePiece{static_cast<std::uint8_t>(i), packets}));
    EXPECT_EQ(packets_of(picture, one.piece).size(), 1U);
    EXPECT_EQ(one.piece.begin(picture), bytes);
    bytes = one.piece.end(picture);
  }
  EXPECT_EQ(bytes, picture);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  EXPECT_EQ(link.counts(TrafficClass::low).delivered, 1U) << "it is one sample";
  EXPECT_EQ(link.counts(TrafficClass::low).sent, 1U);
}

TEST_F(Pieces, OneOfTooManyPacketsGoesAsTheMiddlewareDividesIt) {
  link.offer(1, 1, SamplePiece::most * largest_piece + 1);
  link.run(50 * ms);
  ASSERT_EQ(link.sent.size(), 1U);
  EXPECT_TRUE(link.sent[0].piece.is_whole());
}

TEST_F(Pieces, NothingIsDividedWhileSomebodyReadsWhoKnowsNoPieces) {
  link.sender.set_largest_piece(0);
  link.offer(1, 1, picture);
  link.run(50 * ms);
  ASSERT_EQ(link.sent.size(), 1U);
  EXPECT_TRUE(link.sent[0].piece.is_whole());
  link.loses = [](const Transmission& one) { return one.sample.origin.sequence == 2; };
  link.offer(1, 2, picture);
  link.run(1000 * ms);
  EXPECT_EQ(link.sent.size(), 2U) << "a whole picture is not sent again";
}

TEST_F(Pieces, AStoredSampleGoesWholeSoThatNothingOfItCountsAsDeliveredBeforeAllIs) {
  StreamRule rule = rule_of(TrafficClass::low);
  rule.stored = true;
  link.add(7, rule);
  link.offer(7, 1, picture);
  link.run(50 * ms);
  EXPECT_EQ(link.count_sent(7), 1U);
}

TEST_F(Pieces, OnlyWhatIsMissingIsSentAgainThoughItsClassIsNotRepaired) {
  lose(1, {0, 7, 12});
  link.offer(1, 1, picture);
  link.run(200 * ms);
  EXPECT_EQ(sent_again(), (std::vector<int>{0, 7, 12}));
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  EXPECT_EQ(link.counts(TrafficClass::low).repaired, 1U);
  EXPECT_EQ(link.counts(TrafficClass::low).lost, 0U);
}

TEST_F(Pieces, TheLastPieceIsMissedWhenNoAcknowledgementNamesIt) {
  learn_capacity(link, 1);
  link.sent.clear();
  link.delivered.clear();
  lose(100, {packets - 1});
  link.offer(1, 100, picture);
  link.run(400 * ms);
  EXPECT_EQ(sent_again(), (std::vector<int>{packets - 1}));
  EXPECT_EQ(link.delivered[1], (Sequences{100}));
}

TEST_F(Pieces, APieceIsSentAgainTwiceAtMost) {
  lose(1, {3}, 100);
  link.offer(1, 1, picture);
  link.run(2000 * ms);
  EXPECT_EQ(sent_again(), (std::vector<int>{3, 3}));
  EXPECT_TRUE(link.delivered[1].empty());
  EXPECT_EQ(link.counts(TrafficClass::low).lost, 1U) << "one sample";
}

TEST_F(Pieces, WhatIsMissingGoesBeforeANewPicture) {
  lose(1, {3});
  link.offer(1, 1, picture);
  link.run(35 * ms);  // an acknowledgement has told
  link.offer(1, 2, picture);
  link.run(300 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{1, 2}));
}

TEST_F(Pieces, OfOneThatANewerHasOvertakenNothingIsSentAgain) {
  lose(1, {packets - 1}, 100);
  link.offer(1, 1, picture);
  link.run(30 * ms);
  link.offer(1, 2, picture);  // before the loss of the last piece can be known
  link.run(500 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{2}));
  EXPECT_LE(sent_again().size(), 1U);
}

TEST_F(Pieces, SmallSamplesOfTheClassDoNotWaitForARepair) {
  lose(1, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, 3);
  link.add(3, rule_of(TrafficClass::low));
  link.offer(1, 1, picture);
  link.run(35 * ms);
  link.offer(3, 1);
  link.run(10 * ms);
  EXPECT_EQ(link.delivered[3], (Sequences{1}));
}

TEST_F(Pieces, APausedStreamMendsNothing) {
  StreamRule rule = rule_of(TrafficClass::low);
  rule.while_paused = WhilePaused::latest;
  link.add(4, rule);
  link.loses = [](const Transmission& one) { return one.piece.index == 3 && !one.repair; };
  link.offer(4, 1, picture);
  link.run(2 * ms);
  link.sender.set_paused(true, link.now);
  link.run(300 * ms);
  EXPECT_TRUE(sent_again().empty());
  link.sender.set_paused(false, link.now);
  link.run(300 * ms);
  EXPECT_EQ(link.delivered[4], (Sequences{1}));
}

TEST_F(Pieces, ALateReaderGetsALargeStateInPiecesOfWhichTheLostComeAgain) {
  StreamRule rule = rule_of(TrafficClass::critical);
  rule.durable = true;
  rule.name = "map";
  link.sender.add_stream(5, rule);
  link.receiver.on_stream("vehicle", 5, rule);
  link.dead = true;
  link.offer(5, 1, picture);
  link.run(200 * ms);
  link.dead = false;
  link.loses = [](const Transmission& one) { return one.piece.index % 2 == 0 && !one.repair; };
  link.sender.set_wanted("station", 5, true, link.now);
  link.run(2000 * ms);
  EXPECT_EQ(link.delivered[5], (Sequences{1}));
}

TEST_F(Pieces, TheCapacityIsLearnedOfAPictureThatIsNeverComplete) {
  link.loses = [](const Transmission& one) { return one.piece.index == 3; };
  for (std::uint64_t i = 1; i <= 20; ++i) {
    link.offer(2, i + 1);
    link.offer(1, i, picture);
    link.run(200 * ms);
  }
  // The pair's radio sends a packet in 1 ms.
  const double expected_bytes_per_s =
      static_cast<double>(wire_cost(picture).bytes) / packets / 1e-3;
  EXPECT_NEAR(link.sender.capacity_bytes_per_s(link.now) / expected_bytes_per_s, 1, 0.15);
}

TEST_F(Pieces, OneThatWouldOutliveItsLifespanOnTheWayIsNotSent) {
  StreamRule rule = rule_of(TrafficClass::low);
  rule.lifespan = 1000 * ms;
  link.add(6, rule);
  link.sender.offer(6, {{7, 1, link.now}, picture, nullptr}, link.now);
  link.now += 990 * ms;
  link.run(100 * ms);
  EXPECT_EQ(link.count_sent(6), 0U);
  const ClassCounts counts = link.counts(TrafficClass::low);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::expired)], 1U);
}

TEST_F(Pieces, ARemovedStreamEndsItsPieces) {
  lose(1, {3});
  link.offer(1, 1, picture);
  (void)link.sender.next(link.now);  // the first piece; the others are ready
  link.sender.remove_stream(1);
  link.run(300 * ms);
  EXPECT_EQ(link.count_sent(1), 0U);
}

TEST(PiecesOfALossyLink, PicturesCrossAtTenPercentLossOfEachPacket) {
  std::mt19937 random(1);
  const auto share_of = [&](int low_repairs, double& air) {
    LinkRouterParams params;
    params.low_repairs = low_repairs;
    LinkPair link(params);
    link.add(1, rule_of(TrafficClass::low));
    link.add(2, rule_of(TrafficClass::critical));
    link.loses = [&](const Transmission&) { return random() % 10 == 0; };
    constexpr std::uint64_t pictures = 100;
    for (std::uint64_t i = 1; i <= pictures; ++i) {
      link.offer(1, i, 26000);
      link.offer(2, i);
      link.run(250 * ms);
    }
    air = static_cast<double>(link.count_sent(1)) / (22.0 * pictures);
    return static_cast<double>(link.delivered[1].size()) / pictures;
  };
  double air = 0;
  EXPECT_LT(share_of(0, air), 0.3);
  EXPECT_GT(share_of(2, air), 0.9);
  EXPECT_LT(air, 1.15);
}

}  // namespace
}  // namespace tocsin::router
