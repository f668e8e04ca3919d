// SPDX-License-Identifier: Apache-2.0
#include "link_router/delivery_log.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr PeerIndex station = 1;
constexpr PeerIndex other = 2;

class DeliveryLogTest : public ::testing::Test {
 protected:
  SentSamplePtr send(StreamId stream, TransmissionNumber number, Time at,
                     TrafficClass traffic_class = TrafficClass::low,
                     const std::vector<PeerIndex>& peers = {station}) {
    const auto sent = std::make_shared<SentSample>();
    sent->stream = stream;
    sent->traffic_class = traffic_class;
    sent->missing = peers;
    DeliveryLog::Record record{number, at, {1, 300}, sent, {}};
    for (const PeerIndex peer : peers) record.copies.push_back({peer, at + 2 * ms, false, false});
    sut.add(record);
    return sent;
  }
  static LinkAcknowledgement acknowledgement(StreamId stream, TransmissionNumber highest,
                                             std::uint64_t before, Time made = t0) {
    LinkAcknowledgement one;
    one.made = made;
    one.streams.push_back({stream, highest, 5 * ms, before});
    return one;
  }
  DeliveryLog sut{300 * ms};
};

TEST_F(DeliveryLogTest, TellsWhatCameAndWhenTheNewestDid) {
  const auto first = send(1, 1, t0);
  const auto second = send(1, 2, t0 + ms);
  const auto settled = sut.on_acknowledgement(station, acknowledgement(1, 2, 0b1, t0 + 20 * ms));
  ASSERT_EQ(settled.size(), 2U);
  EXPECT_EQ(settled[0].sample, first);
  EXPECT_TRUE(settled[0].came);
  EXPECT_FALSE(settled[0].is_exact);
  EXPECT_EQ(settled[0].arrived, t0 + 20 * ms);
  EXPECT_EQ(settled[1].sample, second);
  EXPECT_TRUE(settled[1].is_exact);
  EXPECT_EQ(settled[1].arrived, t0 + 15 * ms);
  EXPECT_EQ(sut.next_overdue(), never);
}

TEST_F(DeliveryLogTest, TellsOfEachTransmissionOnce) {
  (void)send(1, 1, t0);
  EXPECT_EQ(sut.on_acknowledgement(station, acknowledgement(1, 1, 0)).size(), 1U);
  EXPECT_TRUE(sut.on_acknowledgement(station, acknowledgement(1, 1, 0)).empty());
}

TEST_F(DeliveryLogTest, GivesUpWhatALaterOneOfItsClassHasOvertaken) {
  const auto lost = send(1, 1, t0);
  const auto of_another_class = send(2, 1, t0, TrafficClass::critical);
  (void)send(3, 1, t0 + ms);
  const auto settled = sut.on_acknowledgement(station, acknowledgement(3, 1, 0));
  ASSERT_EQ(settled.size(), 2U);
  EXPECT_EQ(settled[1].sample, lost);
  EXPECT_FALSE(settled[1].came);
  EXPECT_EQ(of_another_class->under_way, 1U);
}

TEST_F(DeliveryLogTest, GivesUpAfterThePatienceAndTakesALateAcknowledgementAllTheSame) {
  const auto sent = send(1, 1, t0);
  EXPECT_EQ(sut.next_overdue(), t0 + 302 * ms);
  EXPECT_TRUE(sut.give_up_overdue(t0 + 302 * ms - Duration{1}).empty());
  ASSERT_EQ(sut.give_up_overdue(t0 + 302 * ms).size(), 1U);
  EXPECT_EQ(sent->under_way, 0U);
  const auto settled = sut.on_acknowledgement(station, acknowledgement(1, 1, 0));
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_TRUE(settled[0].came);
  EXPECT_TRUE(settled[0].was_settled);
  EXPECT_EQ(sent->under_way, 0U);
}

TEST_F(DeliveryLogTest, KeepsPeersApart) {
  const auto sent = send(1, 1, t0, TrafficClass::low, {station, other});
  EXPECT_EQ(sent->under_way, 2U);
  EXPECT_EQ(sut.on_acknowledgement(station, acknowledgement(1, 1, 0)).size(), 1U);
  EXPECT_EQ(sent->under_way, 1U);
  EXPECT_EQ(sut.count_under_way(other, 0), 1U);
  EXPECT_EQ(sut.forget_peer(other).size(), 1U);
  EXPECT_EQ(sent->under_way, 0U);
  EXPECT_EQ(sut.next_overdue(), never);
}

TEST_F(DeliveryLogTest, ReadsTheWholeWindowOfAAcknowledgementAndNoMore) {
  std::vector<SentSamplePtr> sent;
  for (TransmissionNumber number = 1; number <= 66; ++number) {
    sent.push_back(send(1, number, t0 + static_cast<int>(number) * ms, TrafficClass::high));
  }
  (void)sut.give_up_overdue(t0 + std::chrono::seconds(9));
  const auto settled = sut.on_acknowledgement(station, acknowledgement(1, 66, 1ULL << 63U));
  ASSERT_EQ(settled.size(), 2U);
  EXPECT_EQ(settled[0].sample, sent[1]) << "number 2 is 64 before 66";
}

TEST_F(DeliveryLogTest, AnOldArrivalSaysNothingOfTheDelay) {
  (void)send(1, 1, t0);
  LinkAcknowledgement one = acknowledgement(1, 1, 0, t0 + std::chrono::seconds(6));
  one.streams[0].age = std::chrono::seconds(5);
  EXPECT_FALSE(sut.on_acknowledgement(station, one).at(0).is_exact);
}

}  // namespace
}  // namespace tocsin::router
