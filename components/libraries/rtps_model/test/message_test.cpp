// SPDX-License-Identifier: Apache-2.0
// Lengths as in packets that Debian's Fast DDS 2.9.1 sent on the demo's wlan0.
#include "rtps_model/message.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

using Packets = std::vector<std::size_t>;

constexpr std::size_t around = wire::ip_and_udp + wire::message_header + wire::statistics;

TEST(Message, HasTheLengthOfCapturedPackets) {
  EXPECT_EQ(around + size_of(Heartbeat{1, 1, 1}), 140U);
  EXPECT_EQ(around + wire::info_destination + size_of(AckNack{8, {}, 1}), 152U);
  EXPECT_EQ(around + size_of(Data{sample_of(1, 44), 0}) + size_of(Heartbeat{3, 3, 6}), 220U);
  EXPECT_EQ(around + wire::info_destination + size_of(Data{sample_of(1, 36030), 1}), 1396U);
}

TEST(Message, HasRoomForAFragmentWithDestinationAndHeartbeat) {
  EXPECT_EQ(wire::largest_payload, 1224U);
}

TEST(Message, ABitmapGrowsByWordsOf32Numbers) {
  EXPECT_EQ(size_of(AckNack{10, {10}, 1}), 28U + 4);
  EXPECT_EQ(size_of(AckNack{10, {10, 41}, 1}), 28U + 4);
  EXPECT_EQ(size_of(AckNack{10, {10, 42}, 1}), 28U + 8);
  EXPECT_EQ(size_of(NackFrag{7, {2, 33}, 1}), 32U + 4);
  EXPECT_EQ(size_of(NackFrag{7, {2, 34}, 1}), 32U + 8);
  EXPECT_EQ(size_of(NackFrag{7, {}, 1}), 32U);
  EXPECT_EQ(size_of(Gap{1, 5, {}}), 32U);
  EXPECT_EQ(size_of(Gap{1, 5, {7}}), 32U + 4);
}

TEST(Message, DataEndsAtAMultipleOfFour) {
  EXPECT_EQ(size_of(Data{sample_of(1, 44), 0}), size_of(Data{sample_of(1, 41), 0}));
  EXPECT_EQ(size_of(Data{sample_of(1, 45), 0}), size_of(Data{sample_of(1, 44), 0}) + 4);
}

TEST(Message, AGapBeginsWithTheRunThatStartsIt) {
  const Gap sut = gap_of({3, 4, 5, 8, 9});
  EXPECT_EQ(sut.first, 3U);
  EXPECT_EQ(sut.end, 6U);
  EXPECT_EQ(sut.others, (std::vector<Sequence>{8, 9}));
}

TEST(Sample, KnowsItsFragments) {
  EXPECT_EQ(sample_of(1, 1224)->fragments(), 0U);
  EXPECT_EQ(sample_of(1, 1225)->fragments(), 2U);
  EXPECT_EQ(sample_of(1, 1225)->bytes_of(1), 1224U);
  EXPECT_EQ(sample_of(1, 1225)->bytes_of(2), 1U);
  EXPECT_EQ(sample_of(1, 2448)->bytes_of(2), 1224U);
}

TEST(Packets, KeepASmallSampleWhole) {
  EXPECT_EQ(packets_of(100, 2, 1224), Packets{28 + 20 + 12 + 24 + 60 + 100});
  EXPECT_EQ(packets_of(1224, 2, 1224), Packets{1368});
}

TEST(Packets, NameTheDestinationWhenThereIsOne) {
  EXPECT_EQ(packets_of(100, 1, 1224)[0], packets_of(100, 2, 1224)[0] + wire::info_destination);
}

TEST(Packets, CutALargeSample) {
  EXPECT_EQ(packets_of(1225, 1, 1224).size(), 2U);
  const Packets packets = packets_of(10'000, 1, 1224);
  EXPECT_EQ(packets.front(), 1396U);
  const std::size_t headers = packets.size() * (28 + 36 + 12 + 36 + 60);
  EXPECT_EQ(std::accumulate(packets.begin(), packets.end(), std::size_t{0}), 10'000 + headers);
}

}  // namespace
}  // namespace tocsin::rtps
