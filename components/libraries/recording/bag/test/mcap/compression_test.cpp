// SPDX-License-Identifier: Apache-2.0
#include "compression.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

namespace tocsin::mcap {
namespace {

Span span_of(const Bytes& bytes) { return {bytes.data(), bytes.size()}; }

/// Bytes that can be packed well.
Bytes repetitive(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i / 7 % 11);
  return bytes;
}

class EachCompression : public ::testing::TestWithParam<Compression> {};
INSTANTIATE_TEST_SUITE_P(Packed, EachCompression,
                         ::testing::Values(Compression::lz4, Compression::zstd));

TEST_P(EachCompression, GivesBackWhatItTook) {
  for (const std::size_t size : {1000U, 65'536U, 3'000'000U}) {
    const Bytes original = repetitive(size);
    Bytes packed;
    ASSERT_TRUE(compress(GetParam(), span_of(original), packed)) << size;
    EXPECT_LT(packed.size(), size / 4);
    Bytes back;
    EXPECT_EQ(unpack(name_in_file(GetParam()), span_of(packed), size, back), Unpacked::whole);
    EXPECT_EQ(back, original);
  }
}

TEST_P(EachCompression, SaysWhenNothingIsGained) {
  std::mt19937 random(7);
  Bytes noise(5000);
  for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
  Bytes packed;
  EXPECT_FALSE(compress(GetParam(), span_of(noise), packed));
}

TEST_P(EachCompression, GivesWhatCameBeforeACut) {
  Bytes original(400'000);  // more than a block of either, and not all alike
  std::mt19937 random(3);
  for (std::size_t i = 0; i < original.size(); ++i) {
    original[i] = i % 8 == 0 ? static_cast<std::uint8_t>(random()) : original[i - 1];
  }
  Bytes packed;
  ASSERT_TRUE(compress(GetParam(), span_of(original), packed));
  Bytes back;
  EXPECT_EQ(unpack(name_in_file(GetParam()), {packed.data(), packed.size() * 3 / 4},
                   original.size(), back),
            Unpacked::part);
  EXPECT_GT(back.size(), original.size() / 4);
  EXPECT_TRUE(std::equal(back.begin(), back.end(), original.begin()));
}

TEST_P(EachCompression, TakesNoMemoryForASizeThatIsOnlyClaimed) {
  const Bytes original = repetitive(1000);
  Bytes packed;
  ASSERT_TRUE(compress(GetParam(), span_of(original), packed));
  Bytes back;
  EXPECT_EQ(unpack(name_in_file(GetParam()), span_of(packed), std::uint64_t{1} << 60U, back),
            Unpacked::part);
  EXPECT_EQ(back, original);
  EXPECT_LT(back.capacity(), 1'000'000U);
}

TEST_P(EachCompression, NeverGivesMoreThanIsClaimed) {
  const Bytes original = repetitive(100'000);
  Bytes packed;
  ASSERT_TRUE(compress(GetParam(), span_of(original), packed));
  Bytes back;
  EXPECT_EQ(unpack(name_in_file(GetParam()), span_of(packed), 10, back), Unpacked::whole);
  EXPECT_EQ(back, Bytes(original.begin(), original.begin() + 10));
}

TEST_P(EachCompression, NothingUnpacksToNothing) {
  Bytes back{1, 2, 3};
  EXPECT_EQ(unpack(name_in_file(GetParam()), {}, 0, back), Unpacked::whole);
  EXPECT_TRUE(back.empty());
  EXPECT_EQ(unpack(name_in_file(GetParam()), {}, 5, back), Unpacked::part);
}

TEST(Unpack, LeavesWhatIsNotPackedAsItIs) {
  const Bytes original = repetitive(100);
  Bytes back;
  EXPECT_EQ(unpack("", span_of(original), 100, back), Unpacked::whole);
  EXPECT_EQ(back, original);
  EXPECT_EQ(unpack("", span_of(original), 101, back), Unpacked::part);
}

TEST(Unpack, RefusesACompressionThatNobodyKnows) {
  const Bytes original = repetitive(100);
  Bytes back;
  EXPECT_EQ(unpack("brotli", span_of(original), 100, back), Unpacked::nothing);
  EXPECT_TRUE(back.empty());
}

}  // namespace
}  // namespace tocsin::mcap
