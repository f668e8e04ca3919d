// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_receiver.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr StreamId location = 3;

class LinkReceiverTest : public ::testing::Test {
 protected:
  LinkReceiverTest() {
    sut.on_peer("vehicle", 11);
    sut.on_stream("vehicle", location, rule());
    (void)sut.take_acknowledgement(now);  // the first one only tells that this router is there
  }
  static StreamRule rule(std::size_t depth = 1, Duration lifespan = Duration::max()) {
    StreamRule one;
    one.name = "location";
    one.depth = depth;
    one.lifespan = lifespan;
    return one;
  }
  /// A sample that was made `age` ago.
  Disposition arrive(TransmissionNumber number, std::uint64_t sequence, Duration age = 2 * ms,
                     SourceId source = 7) {
    return sut.on_arrived("vehicle", {location, number, {source, sequence, now - age}}, now);
  }
  /// The acknowledgement that is due next.
  LinkAcknowledgement next_acknowledgement() {
    now = std::max(now, sut.deadline());
    const auto acknowledgement = sut.take_acknowledgement(now);
    return acknowledgement ? acknowledgement->acknowledgement : LinkAcknowledgement{};
  }
  LinkReceiver sut;
  Time now = t0;
};

TEST_F(LinkReceiverTest, DeliversNothingOlderThanItsLifespanWhateverTheClocksShow) {
  const Duration difference = std::chrono::hours(100);
  sut.on_stream("vehicle", location, rule(1, 1000 * ms));
  EXPECT_EQ(arrive(1, 1, difference + 2 * ms), Disposition::deliver);
  EXPECT_EQ(arrive(2, 2, difference + 1001 * ms), Disposition::deliver);
  EXPECT_EQ(arrive(3, 3, difference + 1002 * ms), Disposition::expired)
      << "no way takes less than 1 ms";
}

TEST_F(LinkReceiverTest, WhatComesInABurstAfterAnOutageIsNoStepOfAClock) {
  constexpr Duration outage = std::chrono::minutes(2);  // longer than the window of clocks
  sut.on_stream("vehicle", location, rule(1, 500 * ms));
  EXPECT_EQ(arrive(1, 1), Disposition::deliver);
  now += outage;
  std::uint64_t i = 2;
  for (Duration age = 4000 * ms; age > 500 * ms + 2 * ms; age -= 80 * ms, now += 2 * ms, ++i) {
    EXPECT_EQ(arrive(i, i, age), Disposition::expired) << i;
  }
  EXPECT_EQ(arrive(i, i), Disposition::deliver);
}

TEST_F(LinkReceiverTest, GetsOverAStepOfThePeersClock) {
  sut.on_stream("vehicle", location, rule(1, 1000 * ms));
  for (std::uint64_t i = 1; i < 15; ++i, now += 100 * ms) {
    EXPECT_EQ(arrive(i, i), Disposition::deliver);
  }
  int expired = 0;
  for (std::uint64_t i = 15; i < 40; ++i, now += 100 * ms) {
    expired += arrive(i, i, std::chrono::minutes(10)) == Disposition::expired ? 1 : 0;
  }
  EXPECT_EQ(expired, 8);
  EXPECT_EQ(arrive(40, 40, -std::chrono::minutes(10)), Disposition::deliver) << "and one back";
}

class LinkReceiverPieces : public LinkReceiverTest {
 protected:
  using Contents = std::vector<int>;
  /// One has come. The contents of its sample, when it is the last that was missing.
  Contents piece(TransmissionNumber number, std::uint64_t sequence, std::uint8_t index,
                 std::uint8_t count = 3) {
    const Origin origin{7, sequence, now - 2 * ms};
    const auto content = std::make_shared<int>(index + 10 * static_cast<int>(sequence));
    const auto pieces =
        sut.on_piece("vehicle", {location, number, origin, {index, count}, content}, now);
    Contents contents;
    for (const auto& one : pieces.value_or(std::vector<std::shared_ptr<const void>>{})) {
      contents.push_back(*static_cast<const int*>(one.get()));
    }
    return contents;
  }
};

TEST_F(LinkReceiverPieces, MakeTheSampleInWhateverOrderTheyCome) {
  EXPECT_EQ(piece(1, 1, 2), Contents{});
  EXPECT_EQ(piece(2, 1, 0), Contents{});
  EXPECT_EQ(piece(3, 1, 0), Contents{}) << "doubled";
  EXPECT_EQ(piece(4, 2, 1), Contents{}) << "of another sample";
  EXPECT_EQ(piece(5, 1, 1), (Contents{10, 11, 12}));
}

TEST_F(LinkReceiverPieces, AreAcknowledgedEachByItself) {
  (void)piece(3, 1, 0);
  (void)piece(5, 1, 2);
  const LinkAcknowledgement acknowledgement = next_acknowledgement();
  ASSERT_EQ(acknowledgement.streams.size(), 1U);
  EXPECT_EQ(acknowledgement.streams[0].highest, 5U);
  EXPECT_EQ(acknowledgement.streams[0].before, 0b10U);
}

TEST_F(LinkReceiverPieces, OfAnotherNumberOfPiecesAreAnotherSample) {
  (void)piece(1, 1, 0);
  (void)piece(2, 1, 1);
  EXPECT_EQ(piece(3, 1, 2, 4), Contents{}) << "a forger's";
  EXPECT_EQ(piece(4, 1, 2).size(), 3U);
}

TEST_F(LinkReceiverPieces, OfManyUnfinishedSamplesTheOldestIsForgotten) {
  for (std::uint64_t sequence = 1; sequence <= 9; ++sequence) (void)piece(sequence, sequence, 0);
  (void)piece(10, 1, 1);
  EXPECT_EQ(piece(11, 1, 2), Contents{});
  (void)piece(12, 9, 1);
  EXPECT_EQ(piece(13, 9, 2).size(), 3U);
}

TEST_F(LinkReceiverPieces, OfAnUnknownPeerOrStreamAreNothing) {
  const Arrived of_no_stream{location + 1, 1, {7, 1, now}, {0, 2}, nullptr};
  EXPECT_FALSE(sut.on_piece("vehicle", of_no_stream, now));
  const Arrived of_nobody{location, 1, {7, 1, now}, {0, 2}, nullptr};
  EXPECT_FALSE(sut.on_piece("stranger", of_nobody, now));
}

TEST_F(LinkReceiverTest, AcknowledgementNamesWhatWasReceived) {
  (void)arrive(3, 1);
  (void)arrive(4, 2);
  (void)arrive(7, 3);
  (void)arrive(5, 9);  // a repair that was overtaken
  const Time last = now;
  const LinkAcknowledgement acknowledgement = next_acknowledgement();
  ASSERT_EQ(acknowledgement.streams.size(), 1U);
  EXPECT_EQ(acknowledgement.streams[0].highest, 7U);
  EXPECT_EQ(acknowledgement.streams[0].before, 0b1110U) << "6 did not come; 5, 4, 3 did";
  EXPECT_EQ(acknowledgement.streams[0].age, now - last);
}

TEST_F(LinkReceiverTest, AcknowledgementKeepsTheWholeWindow) {
  (void)arrive(1, 1);
  (void)arrive(65, 2);
  EXPECT_EQ(next_acknowledgement().streams.at(0).before, 1ULL << 63U);
  (void)arrive(66, 3);
  EXPECT_EQ(next_acknowledgement().streams.at(0).before, 1U);
  (void)arrive(200, 4);
  EXPECT_EQ(next_acknowledgement().streams.at(0).before, 0U);
}

TEST_F(LinkReceiverTest, AForgedTransmissionNumberIsForgotten) {
  (void)arrive(1, 1);
  (void)arrive(1U << 30U, 2);
  std::uint64_t i = 3;
  for (const Time begin = now; now - begin <= 600 * ms; now += 100 * ms, ++i) (void)arrive(i, i);
  EXPECT_EQ(next_acknowledgement().streams.at(0).highest, i - 1);
}

TEST_F(LinkReceiverTest, AcknowledgementComesSoonButNotTooOften) {
  now += 500 * ms;
  (void)arrive(1, 1);
  EXPECT_EQ(sut.deadline(), now + acknowledgement_delay);
  (void)next_acknowledgement();
  const Time first = now;
  now += ms;
  (void)arrive(2, 2);
  EXPECT_EQ(sut.deadline(), first + relaxed_period) << "no repair waits for it";
  StreamRule urgent = rule();
  urgent.repaired = true;
  sut.on_stream("vehicle", location, urgent);
  (void)arrive(3, 3);
  EXPECT_EQ(sut.deadline(), first + acknowledgement_period);
}

TEST_F(LinkReceiverTest, AcknowledgementsAreAsFarApartAsTheSenderAsks) {
  StreamRule urgent = rule();
  urgent.repaired = true;
  sut.on_stream("vehicle", location, urgent);
  sut.set_acknowledgement_period(200 * ms);
  now += 500 * ms;
  (void)arrive(1, 1);
  EXPECT_EQ(sut.deadline(), now + acknowledgement_delay) << "the first one waits for nothing";
  (void)next_acknowledgement();
  const Time first = now;
  now += ms;
  (void)arrive(2, 2);
  EXPECT_EQ(sut.deadline(), first + 200 * ms);
}

TEST_F(LinkReceiverTest, AStreamIsInTheAcknowledgementsOfAMomentSoThatOneArrives) {
  const StreamId other = location + 1;
  sut.on_stream("vehicle", other, rule());
  const auto keep_awake = [&] { (void)sut.on_arrived("vehicle", {other, 1, {8, 1, now}}, now); };
  (void)arrive(1, 1);
  const Time arrived = now;
  std::size_t named = 0;
  while (now < arrived + 500 * ms) {
    keep_awake();
    const LinkAcknowledgement acknowledgement = next_acknowledgement();
    const bool names = acknowledgement.streams.front().stream == location;
    EXPECT_EQ(names, now - arrived <= 250 * ms) << to_seconds(now - arrived);
    named += names ? 1 : 0;
  }
  EXPECT_GE(named, 2U);
}

TEST_F(LinkReceiverTest, RepeatsAnAcknowledgementAndThenSendsOnlyOneASecond) {
  (void)arrive(1, 1);
  EXPECT_EQ(next_acknowledgement().streams.size(), 1U);
  EXPECT_EQ(sut.deadline(), now + acknowledgement_idle);
  const LinkAcknowledgement idle = next_acknowledgement();
  EXPECT_EQ(idle.streams.size(), 1U) << "after a silence everything is told once more";
  EXPECT_EQ(idle.count, 3U);
}

TEST_F(LinkReceiverTest, APeersNextInstanceStartsAfreshButRepeatsNothing) {
  EXPECT_EQ(arrive(1, 5), Disposition::deliver);
  sut.on_peer("vehicle", 12);
  EXPECT_EQ(arrive(1, 5), Disposition::unknown_stream);
  sut.on_stream("vehicle", location, rule());
  EXPECT_EQ(arrive(1, 5), Disposition::duplicate);
  EXPECT_EQ(arrive(2, 6), Disposition::deliver);
  EXPECT_EQ(next_acknowledgement().count, 1U);
}

TEST_F(LinkReceiverTest, APeerThatIsGoneGetsNoAcknowledgements) {
  (void)arrive(1, 5);
  sut.forget_peer("vehicle");
  EXPECT_EQ(sut.deadline(), never);
  EXPECT_EQ(arrive(2, 6), Disposition::unknown_stream);
  sut.on_peer("vehicle", 11);
  sut.on_stream("vehicle", location, rule());
  EXPECT_EQ(arrive(3, 5), Disposition::duplicate);
}

}  // namespace
}  // namespace tocsin::router
