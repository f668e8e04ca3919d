// SPDX-License-Identifier: Apache-2.0
// Reading never goes beyond the bytes, whatever they say.
#include "idl_support/wire_cursor.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace tocsin {
namespace {

constexpr std::size_t largest = std::numeric_limits<std::size_t>::max();
using Bytes = std::vector<std::uint8_t>;

/// A message of this content, little endian unless said otherwise.
Bytes message(const Bytes& content, bool little = true) {
  Bytes bytes{0, static_cast<std::uint8_t>(little ? 1 : 0), 0, 0};
  bytes.insert(bytes.end(), content.begin(), content.end());
  return bytes;
}

WireCursor walk(const Bytes& bytes) { return {bytes.data(), bytes.size()}; }

TEST(WireCursor, AMessageHasItsHeaderFromFourBytesOn) {
  EXPECT_FALSE(walk({}).has_header());
  EXPECT_FALSE(walk({0, 1, 0}).has_header());
  EXPECT_TRUE(walk({0, 1, 0, 0}).has_header());
}

TEST(WireCursor, ReadsNumbersOfEitherByteOrder) {
  const std::vector<std::uint16_t> expected{0x0102, 0x0304};
  for (const bool little : {true, false}) {
    const Bytes bytes = message(little ? Bytes{9, 0, 2, 1, 4, 3} : Bytes{9, 0, 1, 2, 3, 4}, little);
    WireCursor sut = walk(bytes);
    std::uint8_t first = 0;
    std::vector<std::uint16_t> numbers(2);
    ASSERT_TRUE(sut.read(&first, 1) && sut.read(numbers.data(), 2)) << little;
    EXPECT_EQ(first, 9);
    EXPECT_EQ(numbers, expected) << little;
    EXPECT_FALSE(sut.read(&first, 1));
  }
}

TEST(WireCursor, PassesWhatIsThereAndNotOneByteMore) {
  const Bytes bytes = message({1, 2, 3});
  WireCursor sut = walk(bytes);
  EXPECT_TRUE(sut.skip(2, 1));
  EXPECT_TRUE(sut.skip(1, 1));
  EXPECT_FALSE(sut.skip(1, 1));
  EXPECT_TRUE(sut.skip(0, 1)) << "nothing is always there";
}

TEST(WireCursor, AlignsByTheWidthCountedFromBehindTheHeader) {
  const Bytes twelve = message(Bytes(12));
  WireCursor four = walk(twelve);
  EXPECT_TRUE(four.skip(1, 1));
  EXPECT_TRUE(four.skip(2, 4)) << "bytes 4 to 11";
  EXPECT_FALSE(four.skip(1, 1));
  WireCursor eight = walk(twelve);
  EXPECT_TRUE(eight.skip(1, 1));
  EXPECT_FALSE(eight.skip(1, 8)) << "would be bytes 8 to 15";
  const Bytes sixteen = message(Bytes(16));
  WireCursor enough = walk(sixteen);
  EXPECT_TRUE(enough.skip(1, 1));
  EXPECT_TRUE(enough.skip(1, 8));
}

TEST(WireCursor, AnEmptySequenceNeedsNoPadding) {
  const Bytes bytes = message({0, 0, 0, 0});
  WireCursor sut = walk(bytes);
  EXPECT_TRUE(sut.skip(4, 1));
  EXPECT_TRUE(sut.skip(0, 8));
  EXPECT_FALSE(sut.skip(1, 1));
}

TEST(WireCursor, ACountThatWouldOverflowIsRefused) {
  const Bytes bytes = message(Bytes(64));
  for (const std::size_t width : {1U, 2U, 4U, 8U}) {
    for (const std::size_t count :
         {largest, largest / width, largest / width / 2, std::size_t{65}}) {
      WireCursor sut = walk(bytes);
      EXPECT_FALSE(sut.skip(count, width)) << count << " of " << width;
      EXPECT_TRUE(sut.skip(64 / width, width)) << "a refused step moves nothing";
    }
  }
}

TEST(WireCursor, ReadsALengthInTheByteOrderOfTheMessage) {
  std::uint32_t length = 0;
  const Bytes little = message({0x78, 0x56, 0x34, 0x12});
  EXPECT_TRUE(walk(little).read_length(length));
  EXPECT_EQ(length, 0x12345678U);
  const Bytes big = message({0x12, 0x34, 0x56, 0x78}, false);
  EXPECT_TRUE(walk(big).read_length(length));
  EXPECT_EQ(length, 0x12345678U);
  const Bytes top = message({0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_TRUE(walk(top).read_length(length));
  EXPECT_EQ(length, 0xFFFFFFFFU);
}

TEST(WireCursor, ALengthThatIsCutIsNone) {
  std::uint32_t length = 7;
  const Bytes bytes = message({1, 0, 0});
  EXPECT_FALSE(walk(bytes).read_length(length));
  EXPECT_EQ(length, 7U);
}

TEST(WireCursor, ALengthBehindABoolIsAligned) {
  const Bytes bytes = message({1, 0xEE, 0xEE, 0xEE, 5, 0, 0, 0});
  WireCursor sut = walk(bytes);
  std::uint32_t length = 0;
  EXPECT_TRUE(sut.skip(1, 1));
  EXPECT_TRUE(sut.read_length(length));
  EXPECT_EQ(length, 5U);
}

TEST(WireCursor, EveryBeginningOfAMessageIsTooShort) {
  // A string "ab" with its zero, then a double.
  const Bytes whole = message({3, 0, 0, 0, 'a', 'b', 0, 0, 1, 2, 3, 4, 5, 6, 7, 8});
  const auto walked = [](const Bytes& bytes) {
    WireCursor sut(bytes.data(), bytes.size());
    std::uint32_t length = 0;
    return sut.has_header() && sut.read_length(length) && sut.skip(length, 1) && sut.skip(1, 8);
  };
  EXPECT_TRUE(walked(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(walked(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))))
        << size;
  }
}

}  // namespace
}  // namespace tocsin
