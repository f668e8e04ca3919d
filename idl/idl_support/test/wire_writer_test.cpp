// SPDX-License-Identifier: Apache-2.0
#include "idl_support/wire_writer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A byte, a number of 32 bits and two of 16, in memory that is not zero.
Bytes written(ByteOrder order, std::size_t capacity) {
  Bytes bytes(capacity, 0xee);
  WireWriter sut(bytes.data(), bytes.size(), order);
  const std::uint8_t small = 9;
  const std::uint32_t large = 0x01020304;
  const std::uint16_t pair[] = {5, 6};
  const bool all = sut.write(&small, 1) && sut.write(&large, 1) && sut.write(pair, 2);
  bytes.resize(all ? sut.size() : 0);
  return bytes;
}

TEST(WireWriter, PutsEachNumberAtAMultipleOfItsSizeWithZerosBetween) {
  EXPECT_EQ(written(ByteOrder::little, 20), (Bytes{9, 0, 0, 0, 4, 3, 2, 1, 5, 0, 6, 0}));
  EXPECT_EQ(written(ByteOrder::big, 20), (Bytes{9, 0, 0, 0, 1, 2, 3, 4, 0, 5, 0, 6}));
}

TEST(WireWriter, WritesNothingBeyondItsCapacity) {
  for (std::size_t capacity = 0; capacity < 12; ++capacity) {
    EXPECT_EQ(written(ByteOrder::little, capacity), Bytes()) << capacity;
  }
  EXPECT_EQ(written(ByteOrder::little, 12).size(), 12U);
}

TEST(WireWriter, WritesNothingAnyMoreAfterARefusal) {
  Bytes bytes(6, 0xee);
  WireWriter sut(bytes.data(), bytes.size(), ByteOrder::little);
  const std::uint64_t large = 1;
  const std::uint8_t small = 2;
  EXPECT_FALSE(sut.write(&large, 1));
  EXPECT_FALSE(sut.write(&small, 1));
  EXPECT_EQ(bytes, Bytes(6, 0xee));
}

TEST(WireWriter, NothingTakesNoPadding) {
  Bytes bytes(6, 0xee);
  WireWriter sut(bytes.data(), bytes.size(), ByteOrder::little);
  const std::uint8_t small = 2;
  const double none = 0;
  EXPECT_TRUE(sut.write(&small, 1) && sut.write(&none, 0));
  EXPECT_EQ(sut.size(), 1U);
}

TEST(WireSize, IsThatOfWhatIsWritten) {
  WireSize sut;
  const std::uint8_t small = 9;
  const std::uint64_t large[2] = {};
  sut.write(&small, 1);
  sut.write(large, 0);
  EXPECT_EQ(sut.size(), 1U);
  sut.write(large, 2);
  EXPECT_EQ(sut.size(), 24U);
}

}  // namespace
}  // namespace tocsin
