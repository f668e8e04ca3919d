// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/key_repeats.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using Bytes = std::vector<std::uint8_t>;

constexpr Time t0{std::chrono::seconds(1000)};

class KeyRepeatsTest : public ::testing::Test {
 protected:
  static KeyRepeats::Packet packet(std::uint8_t content, std::size_t size, int port = 17910) {
    KeyRepeats::Packet one{Bytes(size, content), {}};
    one.to.port = static_cast<std::uint32_t>(port);
    return one;
  }
  static KeyRepeats::Packet keys(std::uint8_t content, int port = 17910) {
    return packet(content, KeyRepeats::least_key_bytes, port);
  }
  static KeyRepeats::Packet request(std::uint8_t content) {
    return packet(content, KeyRepeats::least_key_bytes - 1);
  }
  /// First bytes of all that are due.
  Bytes due(Time now) {
    Bytes all;
    while (const auto one = sut_.take_due(now)) all.push_back(one->bytes.front());
    return all;
  }
  KeyRepeats sut_;
};

TEST_F(KeyRepeatsTest, TheLastPacketIsSentAgainAfterPausesThatDouble) {
  EXPECT_EQ(sut_.deadline(), never);
  sut_.sent(keys(7), t0);
  Time now = t0;
  for (const int pause_ms : {50, 100, 200, 400, 800}) {
    EXPECT_EQ(sut_.deadline(), now + milliseconds(pause_ms));
    EXPECT_TRUE(due(now + milliseconds(pause_ms - 1)).empty());
    now += milliseconds(pause_ms);
    const auto again = sut_.take_due(now);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->bytes, keys(7).bytes);
    EXPECT_EQ(again->to.port, 17910U);
  }
  EXPECT_EQ(sut_.deadline(), never);
}

TEST_F(KeyRepeatsTest, TheNextOneTakesItsPlace) {
  sut_.sent(keys(7), t0);
  sut_.sent(keys(8), t0 + milliseconds(49));
  EXPECT_TRUE(due(t0 + milliseconds(98)).empty());
  EXPECT_EQ(due(t0 + milliseconds(99)), Bytes{8});
}

TEST_F(KeyRepeatsTest, KeysAndRequestsAreRepeatedForThemselves) {
  sut_.sent(keys(7), t0);
  sut_.sent(request(8), t0);
  EXPECT_EQ(due(t0 + milliseconds(50)).size(), 2U);
}

TEST_F(KeyRepeatsTest, EachAddressHasItsOwn) {
  sut_.sent(keys(7, 17910), t0);
  sut_.sent(keys(8, 17912), t0);
  EXPECT_EQ(due(t0 + milliseconds(50)).size(), 2U);
}

TEST_F(KeyRepeatsTest, ManyAddressesAreNotAllRepeated) {
  for (int port = 1; port <= 100; ++port) sut_.sent(keys(1, port), t0);
  EXPECT_EQ(due(t0 + milliseconds(50)).size(), KeyRepeats::most_packets);
}

}  // namespace
}  // namespace tocsin
