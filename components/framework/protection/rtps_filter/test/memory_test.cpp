// SPDX-License-Identifier: Apache-2.0
// What Fast DDS would keep for a sender, and how much of it.
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::seconds;

constexpr std::uint32_t mib = 1U << 20U;
constexpr std::uint32_t fragment_bytes = 60'000;

/// A participant with a writer, known to `sut`.
void meet(RtpsFilter& sut) {
  const Wire list = Wire().parameter(0x5a, guid_of('a', user_writer)).sentinel();
  (void)inspect(sut, announcement('a'));
  (void)inspect(sut, data_of(data_head(sedp_writer).raw(parameters_payload(list))));
}

Bytes fragment(std::int64_t sample, std::uint32_t number, std::uint32_t sample_bytes,
               std::uint32_t writer = user_writer) {
  const std::uint32_t begin = (number - 1) * fragment_bytes;
  const Wire content = data_head(writer, sample, 28)
                           .u32(number)
                           .u16(1)
                           .u16(fragment_bytes)
                           .u32(sample_bytes)
                           .zeros(std::min(fragment_bytes, sample_bytes - begin));
  return Message('a').add(0x16, 0, content.bytes()).bytes();
}

TEST(Samples, ThatBeginAndDoNotEndAreSoonTooMany) {
  RtpsFilter sut{Limits{}};
  meet(sut);
  for (std::int64_t sample = 1; sample <= 3; ++sample) {
    EXPECT_EQ(drop_of(sut, fragment(sample, 1, 16 * mib)), passes) << sample;
  }
  EXPECT_EQ(drop_of(sut, fragment(4, 1, 16 * mib)), DropReason::sample_size);
  EXPECT_EQ(drop_of(sut, fragment(3, 2, 16 * mib)), passes) << "it has begun";
  EXPECT_EQ(drop_of(sut, fragment(4, 1, 16 * mib), alice, t0 + seconds(16)), passes);
}

TEST(Samples, ThatEndAreAsManyAsCome) {
  RtpsFilter sut{Limits{}};
  meet(sut);
  for (std::int64_t sample = 1; sample <= 30; ++sample) {
    for (std::uint32_t number = 1; number <= (5 * mib - 1) / fragment_bytes + 1; ++number) {
      ASSERT_EQ(drop_of(sut, fragment(sample, number, 5 * mib)), passes);
    }
  }
}

TEST(Samples, OfTheLargestSizePassByThemselves) {
  RtpsFilter sut{Limits{}};
  meet(sut);
  EXPECT_EQ(drop_of(sut, fragment(1, 1, 64 * mib)), passes);
}

TEST(Samples, OfAWriterThatNobodyKnowsCostNothing) {
  RtpsFilter sut{Limits{}};
  meet(sut);
  for (std::int64_t sample = 1; sample <= 20; ++sample) {
    EXPECT_EQ(drop_of(sut, fragment(sample, 1, 16 * mib, 0x00000203)), passes);
  }
  EXPECT_EQ(drop_of(sut, fragment(1, 1, 16 * mib)), passes);
}

TEST(Gaps, BeyondAHoleAreFewWhoeverSendsThem) {
  Limits limits;
  limits.kept_numbers = {1000, 10};
  RtpsFilter sut(limits);
  (void)inspect(sut, announcement('a'));
  (void)inspect(sut, announcement('b'));
  EXPECT_EQ(drop_of(sut, gap('a', 2, 602)), passes);
  EXPECT_EQ(drop_of(sut, gap('b', 2, 402)), passes);
  EXPECT_EQ(drop_of(sut, gap('b', 2, 3)), DropReason::gap_range);
  EXPECT_EQ(drop_of(sut, gap('b', 1, 100'000)), passes) << "there is no hole before it";
  EXPECT_EQ(drop_of(sut, gap('b', 2, 12), alice, t0 + seconds(1)), passes);
}

std::optional<DropReason> drop_of_liveliness(std::uint32_t kind, std::uint32_t bytes) {
  const Wire payload =
      Wire().raw({0, 1, 0, 0}).raw(prefix_of('a')).entity(kind).u32(bytes).zeros(bytes);
  return drop_of(data_of(data_head(0x000200c2).raw(payload.bytes())));
}

TEST(Liveliness, IsOfAKnownKindAndSmall) {
  EXPECT_EQ(drop_of_liveliness(1, 0), passes);
  EXPECT_EQ(drop_of_liveliness(2, 488), passes);
  EXPECT_EQ(drop_of_liveliness(2, 492), DropReason::discovery_payload);
  EXPECT_EQ(drop_of_liveliness(3, 0), DropReason::discovery_payload);
  EXPECT_EQ(drop_of_liveliness(0x01000001, 0), DropReason::discovery_payload);
  const Wire qos = Wire().parameter(0x70, guid_of('a', 0x80000001)).sentinel();
  EXPECT_EQ(drop_of(data_of(data_head(0x000200c2).raw(qos.bytes()), with_qos)),
            DropReason::discovery_payload);
}

}  // namespace
}  // namespace tocsin::rtps_filter
