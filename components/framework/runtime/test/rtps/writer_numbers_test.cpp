// SPDX-License-Identifier: Apache-2.0
#include "rtps/writer_numbers.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace tocsin {
namespace {

constexpr Duration ms = std::chrono::milliseconds(1);

class WriterNumbersTest : public ::testing::Test {
 protected:
  bool arrives(std::uint64_t number) {
    now_ += 100 * ms;
    return sut_.is_muted(writer_, number, now_);
  }
  WriterNumbers::Guid writer_ = [] {
    WriterNumbers::Guid guid;
    guid.guidPrefix.value[0] = 1;
    guid.entityId.value[3] = 3;
    return guid;
  }();
  int wakes_ = 0;
  WriterNumbers sut_{[this] { ++wakes_; }};
  Time now_{std::chrono::hours(1)};
};

TEST_F(WriterNumbersTest, AscendingNumbersWithGapsMuteNothing) {
  for (const std::uint64_t number : {1U, 2U, 5U, 6U, 400U, 401U}) EXPECT_FALSE(arrives(number));
}

TEST_F(WriterNumbersTest, OneHighNumberMutesUntilTrueOnesHaveGoneOnFor300Ms) {
  EXPECT_FALSE(arrives(7));
  EXPECT_FALSE(arrives(1ULL << 40U));
  EXPECT_FALSE(arrives(8));
  EXPECT_FALSE(arrives(9));
  EXPECT_FALSE(arrives(10));
  EXPECT_TRUE(arrives(11));
  for (std::uint64_t number = 12; number < 30; ++number) EXPECT_FALSE(arrives(number));
}

TEST_F(WriterNumbersTest, ASlowWriterIsFreeWithItsSecondSample) {
  EXPECT_FALSE(arrives(7));
  EXPECT_FALSE(arrives(12));
  now_ += 1000 * ms;
  EXPECT_FALSE(arrives(8));
  now_ += 1000 * ms;
  EXPECT_TRUE(arrives(9));
}

TEST_F(WriterNumbersTest, PacketsThatOvertakeEachOtherOrComeTwiceTellNothing) {
  for (const std::uint64_t number : {1U, 4U, 2U, 3U, 4U, 5U, 8U, 6U, 7U, 9U}) {
    EXPECT_FALSE(arrives(number)) << number;
  }
}

TEST_F(WriterNumbersTest, ReplayedPacketsBesideTrueOnesTellNothing) {
  for (std::uint64_t number = 100; number < 160; ++number) {
    EXPECT_FALSE(arrives(number));
    EXPECT_FALSE(arrives(number - 90));
  }
}

TEST_F(WriterNumbersTest, WritersAreToldApart) {
  EXPECT_FALSE(arrives(1ULL << 40U));
  WriterNumbers::Guid other = writer_;
  other.entityId.value[2] = 9;
  for (std::uint64_t number = 1; number < 10; ++number) {
    now_ += 100 * ms;
    EXPECT_FALSE(sut_.is_muted(other, number, now_));
  }
}

TEST_F(WriterNumbersTest, ReadsDataOfPackets) {
  const auto packet = [](int entity_kind, int number) {
    std::vector<std::uint8_t> bytes{'R', 'T', 'P', 'S', 2, 3, 1, 15, 1, 0,
                                    0,   0,   0,   0,   0, 0, 0, 0,  0, 0};
    const std::vector<int> submessage{0x15, 5,           24, 0, 0, 0, 16,     0, 0, 0, 0, 0, 0, 0,
                                      0,    entity_kind, 0,  0, 0, 0, number, 0, 0, 0, 0, 1, 0, 0};
    for (const int one : submessage) bytes.push_back(static_cast<std::uint8_t>(one));
    return bytes;
  };
  for (const int kind : {0x03, 0xc2}) {  // an ordinary writer, one of discovery
    for (const int number : {9, 1, 2}) {
      const auto bytes = packet(kind, number);
      sut_.see(bytes.data(), bytes.size(), now_ += 400 * ms);
    }
  }
  EXPECT_EQ(wakes_, 1);
  EXPECT_EQ(sut_.take_muted(), std::set<WriterNumbers::Guid>{writer_});
  EXPECT_TRUE(sut_.take_muted().empty());
}

TEST_F(WriterNumbersTest, TakesShortPackets) {
  const std::vector<std::uint8_t> bytes(64, 0x15);
  for (std::size_t size = 0; size <= bytes.size(); ++size) sut_.see(bytes.data(), size, now_);
  EXPECT_EQ(wakes_, 0);
}

}  // namespace
}  // namespace tocsin
