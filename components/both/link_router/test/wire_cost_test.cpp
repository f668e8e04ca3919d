// SPDX-License-Identifier: Apache-2.0
// Lengths as in packets that Debian's Fast DDS 2.9.1 sent on the demo's wlan0, without its
// statistics.
#include "link_router/wire_cost.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace tocsin::router {
namespace {

using Packets = std::vector<std::size_t>;

TEST(WireCost, ASmallSampleIsOnePacketWithAllHeadersAndItsOrigin) {
  EXPECT_EQ(packets_of(100), Packets{28 + 20 + 16 + 12 + 24 + 32 + 100});
}

TEST(WireCost, ASampleIsWholeAsLongAsItFitsAMessageOf1400Bytes) {
  ASSERT_EQ(packets_of(1192).size(), 1U);
  EXPECT_LE(packets_of(1192)[0], 1428U);
  EXPECT_EQ(packets_of(1193).size(), 2U);
}

TEST(WireCost, ALongOneIsCut) {
  const Packets packets = packets_of(10'000);
  ASSERT_EQ(packets.size(), 9U);
  EXPECT_EQ(packets.front(), 1192U + 28 + 20 + 16 + 12 + 36 + 32);
  EXPECT_EQ(std::accumulate(packets.begin(), packets.end(), std::size_t{0}), 10'000U + 9 * 144);
}

TEST(WireCost, DataEndsAtAMultipleOfFour) {
  EXPECT_EQ(packets_of(41), packets_of(44));
  EXPECT_EQ(packets_of(45)[0], packets_of(44)[0] + 4);
}

TEST(WireCost, AMessageBetweenRoutersHasNoOrigin) {
  EXPECT_EQ(packet_without_origin(101), packets_of(101).front() - 32);
}

}  // namespace
}  // namespace tocsin::router
