// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/acknack_counts.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Fields {
  std::uint8_t reader = 1;
  std::uint8_t writer = 1;
  std::uint32_t base = 5;
  std::uint32_t bits = 0;
  std::uint32_t count = 1;
  bool final = true;
  bool little_endian = true;
};

void put(Bytes& bytes, std::uint32_t value, bool little_endian) {
  for (unsigned i = 0; i < 4; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8U * (little_endian ? i : 3 - i)));
  }
}

/// RTPS 2.2 section 9.4.5.3.
Bytes submessage(const Fields& fields) {
  const bool little = fields.little_endian;
  const auto size = static_cast<std::uint8_t>(24 + (fields.bits + 31) / 32 * 4);
  Bytes bytes{0x06, static_cast<std::uint8_t>((little ? 1 : 0) | (fields.final ? 2 : 0))};
  bytes.insert(bytes.end(), {little ? size : std::uint8_t{0}, little ? std::uint8_t{0} : size});
  bytes.insert(bytes.end(), {0, 0, fields.reader, 4, 0, 0, fields.writer, 3});
  put(bytes, 0, little);
  put(bytes, fields.base, little);
  put(bytes, fields.bits, little);
  for (std::uint32_t i = 0; i < (fields.bits + 31) / 32; ++i) put(bytes, 0xffffffffU, little);
  put(bytes, fields.count, little);
  return bytes;
}

Bytes message(const std::vector<Fields>& acknacks, std::uint8_t sender = 1) {
  Bytes bytes{'R', 'T', 'P', 'S', 2, 1, 1, 16, sender, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const Bytes destination{0x0e, 1, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  bytes.insert(bytes.end(), destination.begin(), destination.end());
  for (const Fields& one : acknacks) {
    const Bytes more = submessage(one);
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  return bytes;
}

class AckNackCountsTest : public ::testing::Test {
 protected:
  Bytes told(const Bytes& bytes) {
    Bytes changed;
    const auto result = sut_.translate(bytes.data(), bytes.size(), changed);
    return {result.first, result.first + result.second};
  }
  AckNackCounts sut_;
};

TEST_F(AckNackCountsTest, LeavesTheCountsOfAReaderThatNeverStartsAnew) {
  for (const std::uint32_t count : {1U, 2U, 2U, 7U}) {
    const Bytes bytes = message({{1, 1, 5, 3, count}});
    EXPECT_EQ(told(bytes), bytes);
  }
}

TEST_F(AckNackCountsTest, AskingAnewGetsTheNextCountAndTheBaseThatFastDdsKnows) {
  (void)told(message({{1, 1, 9, 0, 40}}));
  const Bytes as_cyclone = message({{1, 1, 1, 0, 0, false}});
  EXPECT_EQ(told(as_cyclone), message({{1, 1, 0, 0, 41, false}}));
  EXPECT_EQ(told(as_cyclone), message({{1, 1, 0, 0, 42, false}}));
}

TEST_F(AckNackCountsTest, WhatFollowsGoesOnFromThere) {
  (void)told(message({{1, 1, 9, 0, 40}}));
  (void)told(message({{1, 1, 1, 0, 0, false}}));
  EXPECT_EQ(told(message({{1, 1, 1, 8, 1}})), message({{1, 1, 1, 8, 42}}));
  EXPECT_EQ(told(message({{1, 1, 9, 0, 2}})), message({{1, 1, 9, 0, 43}}));
  EXPECT_EQ(told(message({{1, 1, 9, 0, 2}})), message({{1, 1, 9, 0, 43}})) << "heard twice";
}

TEST_F(AckNackCountsTest, ThatOfFastDdsWithABaseOfZeroIsPreemptiveToo) {
  (void)told(message({{1, 1, 9, 0, 40}}));
  EXPECT_EQ(told(message({{1, 1, 0, 0, 1, false}})), message({{1, 1, 0, 0, 41, false}}));
}

// Heard a heartbeat before it could ask for one. Fast DDS must not take what it asks for as
// acknowledged.
TEST_F(AckNackCountsTest, AReaderThatTakesBackWhatItHadAcknowledgedAsksAnewBeforeItAsks) {
  for (const bool little : {true, false}) {
    const auto writer = static_cast<std::uint8_t>(little ? 1 : 3);
    (void)told(message({{1, writer, 9, 0, 40}}));
    EXPECT_EQ(told(message({{1, writer, 1, 8, 41, true, little}, {2, writer, 1, 8, 1}})),
              message({{1, writer, 0, 0, 41, false, little},
                       {1, writer, 1, 8, 42, true, little},
                       {2, writer, 1, 8, 1}}));
    EXPECT_EQ(told(message({{1, writer, 1, 8, 42}})), message({{1, writer, 1, 8, 43}}));
    EXPECT_EQ(told(message({{1, writer, 9, 0, 43}})), message({{1, writer, 9, 0, 44}}));
  }
}

TEST_F(AckNackCountsTest, SoDoesOneWhoseCountStartsAnewToo) {
  (void)told(message({{1, 1, 9, 0, 40}}));
  EXPECT_EQ(told(message({{1, 1, 8, 0, 1, true}})),
            message({{1, 1, 0, 0, 41, false}, {1, 1, 8, 0, 42, true}}));
  EXPECT_EQ(told(message({{1, 1, 9, 0, 2}})), message({{1, 1, 9, 0, 43}}));
}

TEST_F(AckNackCountsTest, AFinalOneOrOneThatAsksForSamplesIsNotPreemptive) {
  const Bytes final = message({{1, 1, 1, 0, 3, true}});
  EXPECT_EQ(told(final), final);
  const Bytes asking = message({{2, 1, 1, 1, 3, false}});
  EXPECT_EQ(told(asking), asking);
}

TEST_F(AckNackCountsTest, CountsEachReaderAtEachWriterOfEachParticipant) {
  (void)told(message({{1, 1, 9, 0, 40}}));
  EXPECT_EQ(told(message({{2, 1, 9, 0, 1}})), message({{2, 1, 9, 0, 1}}));
  EXPECT_EQ(told(message({{1, 2, 9, 0, 1}})), message({{1, 2, 9, 0, 1}}));
  EXPECT_EQ(told(message({{1, 1, 9, 0, 1}}, 7)), message({{1, 1, 9, 0, 1}}, 7));
}

TEST_F(AckNackCountsTest, TranslatesEveryAckNackOfAMessageInEitherByteOrder) {
  const Fields anew{1, 1, 1, 0, 0, false, false};
  const Fields other{1, 2, 1, 0, 0, false, true};
  Fields anew_told = anew;
  Fields other_told = other;
  anew_told.base = other_told.base = 0;
  anew_told.count = other_told.count = 1;
  EXPECT_EQ(told(message({anew, other})), message({anew_told, other_told}));
}

TEST_F(AckNackCountsTest, AMessageThatIsCutOffOrLiesAboutItsLengthStaysAsItIs) {
  const Bytes whole = message({{1, 1, 1, 0, 0, false}});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(told(part), part) << size;
  }
  Bytes many_bits = message({{1, 1, 1, 8, 4}});
  many_bits[20 + 16 + 4 + 16 + 1] = 0xff;  // 65288 bits
  EXPECT_EQ(told(many_bits), many_bits);
}

TEST_F(AckNackCountsTest, ACountThatWrapsIsTheNextOne) {
  (void)told(message({{1, 1, 9, 0, 0xffffffffU}}));
  EXPECT_EQ(told(message({{1, 1, 9, 0, 0}})), message({{1, 1, 9, 0, 0}}));
}

TEST_F(AckNackCountsTest, RemembersAReaderThatIsHeardAmongThousandsThatAreNot) {
  (void)told(message({{1, 1, 9, 0, 40}}));
  (void)told(message({{1, 1, 1, 0, 0, false}}));
  std::uint32_t count = 1;
  for (unsigned i = 0; i < 30'000; ++i) {
    (void)told(
        message({{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8U), 9, 0, 1}},
                static_cast<std::uint8_t>(2 + i % 200)));
    if (i % 1000 == 0) {
      EXPECT_EQ(told(message({{1, 1, 9, 0, count}})), message({{1, 1, 9, 0, 41 + count}}));
      ++count;
    }
  }
}

}  // namespace
}  // namespace tocsin
