// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/sample_codec.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tocsin {
namespace {

using Bytes = SampleCodec::Bytes;

/// A serialised sample: mostly the same in each of a row, and zeros, as odometry is.
Bytes sample(std::uint32_t number, std::size_t bytes = 720) {
  Bytes made{0, 1, 0, 0};
  made.resize(bytes);
  std::mt19937 same(1);
  for (std::size_t i = 4; i < 60; ++i) made[i] = static_cast<std::uint8_t>(same());
  std::mt19937 other(number);
  for (std::size_t i = 60; i < 100; ++i) made[i] = static_cast<std::uint8_t>(other());
  return made;
}

TEST(SampleCodec, WhatComesOutIsWhatWentIn) {
  SampleCodec sut;
  for (const std::size_t bytes : {4U, 5U, 100U, 720U, 30'000U}) {
    Bytes plain = sample(1, std::max<std::size_t>(bytes, 100));
    plain.resize(bytes);
    EXPECT_EQ(sut.restore(sut.compress(plain, {}), {}), plain);
    EXPECT_EQ(sut.restore(sut.compress(plain, sample(2)), sample(2)), plain);
  }
}

TEST(SampleCodec, ASampleThatIsLikeItsBaseTakesWhatIsNewInIt) {
  SampleCodec sut;
  const std::size_t alone = sut.compress(sample(1), {}).size();
  const std::size_t based = sut.compress(sample(1), sample(2)).size();
  EXPECT_LT(alone, 160U);
  EXPECT_LT(based, 80U) << "40 bytes are new";
}

TEST(SampleCodec, WhatComesOutIsASerialisedSampleThatTellsItsPadding) {
  SampleCodec sut;
  for (std::uint32_t i = 0; i < 20; ++i) {
    Bytes compressed = sut.compress(sample(i, 720 + i), {});
    EXPECT_EQ(compressed[1], 1);
    const std::size_t padding = compressed[3];
    EXPECT_EQ((compressed.size() + padding) % 4, 0U);
    compressed.resize(compressed.size() + padding);  // as it arrives
    EXPECT_EQ(sut.restore(compressed, {}), sample(i, 720 + i));
  }
}

TEST(SampleCodec, AnotherBaseIsNoticed) {
  SampleCodec sut;
  const Bytes compressed = sut.compress(sample(1), sample(2));
  Bytes other = sample(2);
  other[20] ^= 1;  // of what both have
  EXPECT_FALSE(sut.restore(compressed, other));
  EXPECT_FALSE(sut.restore(compressed, {}));
  EXPECT_EQ(sut.restore(compressed, sample(2)), sample(1)) << "and nothing is left of the attempt";
}

TEST(SampleCodec, DamagedBytesGiveNothing) {
  SampleCodec sut;
  const Bytes good = sut.compress(sample(1), {});
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    Bytes bad = good;
    if (random() % 4 == 0) bad.resize(random() % bad.size());
    for (unsigned n = 1 + random() % 3; n > 0 && !bad.empty(); --n) {
      bad[random() % bad.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
    }
    const auto restored = sut.restore(bad, {});
    // The encapsulation header is not covered: nothing depends on it.
    if (restored) EXPECT_EQ(*restored, sample(1));
  }
}

TEST(SampleCodec, WhatClaimsToBeHugeIsNotRestored) {
  SampleCodec sut;
  EXPECT_FALSE(sut.restore(sut.compress(Bytes(SampleCoding::largest + 1), {}), {}));
  EXPECT_TRUE(sut.restore(sut.compress(Bytes(SampleCoding::largest), {}), {}));
  EXPECT_FALSE(sut.restore({}, {}));
  EXPECT_FALSE(sut.restore({0, 1, 0, 0}, {}));
}

}  // namespace
}  // namespace tocsin
