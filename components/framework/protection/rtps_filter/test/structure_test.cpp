// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

TEST(Header, MustBeRtpsOfVersionTwo) {
  Bytes message = data_of(data_head(user_writer).raw(small_payload()));
  EXPECT_EQ(drop_of(message), passes);
  EXPECT_EQ(drop_of({message.begin(), message.begin() + 19}), DropReason::not_rtps);
  message[4] = 3;
  EXPECT_EQ(drop_of(message), DropReason::not_rtps);
  EXPECT_EQ(drop_of({}), DropReason::not_rtps);
}

TEST(Submessage, EndsWithinItsPacket) {
  const Bytes content = data_head(user_writer).raw(small_payload()).bytes();
  const auto length = static_cast<std::uint32_t>(content.size());
  EXPECT_EQ(drop_of(Message().add_of_length(0x15, length, content).bytes()), passes);
  EXPECT_EQ(drop_of(Message().add_of_length(0x15, length + 1, content).bytes()),
            DropReason::submessage_length);
}

TEST(Submessage, OfLengthZeroReachesToTheEnd) {
  const Bytes content = data_head(user_writer).raw(small_payload()).bytes();
  const Bytes message = Message().add_of_length(0x15, 0, content).bytes();
  EXPECT_EQ(drop_of(Message().add(0x15, with_data, content).bytes()), passes);
  EXPECT_EQ(drop_of(message), passes);
}

TEST(Submessage, BeginsAtAMultipleOfFourBytes) {
  const Bytes content(5, 0);
  EXPECT_EQ(drop_of(Message().add(0x7f, 0, content).bytes()), passes);  // the last may end anywhere
  EXPECT_EQ(drop_of(Message().add(0x7f, 0, content).add(0x01, 0, {}).bytes()),
            DropReason::submessage_length);
}

TEST(Submessage, OfUnknownKindIsSkipped) {
  EXPECT_EQ(drop_of(Message().add(0x7f, 0, Bytes(8, 0xff)).bytes()), passes);
  EXPECT_EQ(drop_of(Message().add(0x80, 0, Bytes(8, 0xff)).bytes()), passes);  // another vendor's
}

TEST(Submessage, ThatIsShorterThanItsKindIsDropped) {
  struct Case {
    std::uint32_t kind;
    std::uint32_t smallest;
  };
  // INFO_TS, INFO_DST, HEARTBEAT_FRAG, and what DDS Security seals
  for (const Case& one : {Case{0x09, 8}, Case{0x0e, 12}, Case{0x13, 24}, Case{0x31, 20},
                          Case{0x32, 20}, Case{0x33, 20}, Case{0x34, 20}}) {
    EXPECT_EQ(drop_of(Message().add(one.kind, 0, Bytes(one.smallest, 0)).bytes()), passes)
        << one.kind;
    EXPECT_EQ(drop_of(Message().add(one.kind, 0, Bytes(one.smallest - 4, 0)).add(1, 0, {}).bytes()),
              DropReason::submessage_length)
        << one.kind;
  }
}

TEST(Submessage, TimestampMayBeInvalidated) {
  constexpr std::uint32_t invalidate = 2;
  EXPECT_EQ(drop_of(Message().add(0x09, invalidate, {}).bytes()), passes);
}

TEST(Statistics, OfFastDdsMustBeWholeAndAtTheEnd) {
  constexpr std::uint32_t eprosima = 0x010f;
  const Bytes whole(56, 0);
  EXPECT_EQ(drop_of(Message('a', eprosima).add(0x80, 0, whole).bytes()), passes);
  EXPECT_EQ(drop_of(Message('a', eprosima).add(0x80, 0, Bytes(52, 0)).bytes()),
            DropReason::vendor_submessage);
  EXPECT_EQ(drop_of(Message('a', eprosima).add(0x80, 0, whole).add(1, 0, {}).bytes()),
            DropReason::vendor_submessage);
}

TEST(Source, InfoSrcMustNameTheSender) {
  const auto info_src = [](char name) {
    return Message('a').add(0x0c, 0, Wire().u32(0).raw({2, 1, 1, 3}).raw(prefix_of(name)).bytes());
  };
  EXPECT_EQ(drop_of(info_src('a').bytes()), passes);
  EXPECT_EQ(drop_of(info_src('b').bytes()), DropReason::foreign_identity);
}

TEST(Data, InlineQosBeginsBehindTheHeaderAndWithin) {
  const Bytes list = Wire().parameter(0x70, Bytes(16, 7)).sentinel().bytes();
  const auto with = [&](std::uint32_t octets) {
    return drop_of(data_of(data_head(user_writer, 1, octets).raw(list).raw(small_payload()),
                           with_qos | with_data));
  };
  EXPECT_EQ(with(16), passes);
  EXPECT_EQ(with(0), DropReason::inline_qos_offset);
  EXPECT_EQ(with(15), DropReason::inline_qos_offset);
  EXPECT_EQ(with(1000), DropReason::inline_qos_offset);
  EXPECT_EQ(with(0xfffc), DropReason::inline_qos_offset);
}

TEST(Data, OffsetCountsWithoutInlineQosToo) {
  EXPECT_EQ(drop_of(data_of(data_head(user_writer, 1, 1000).raw(small_payload()))),
            DropReason::inline_qos_offset);
}

TEST(Data, InlineQosIsACompleteList) {
  const auto with = [](const Wire& list) {
    return drop_of(data_of(data_head(user_writer).raw(list.bytes()), with_qos));
  };
  EXPECT_EQ(with(Wire().sentinel()), passes);
  EXPECT_EQ(with(Wire().parameter(0x71, {0, 0, 0, 1}).sentinel()), passes);
  EXPECT_EQ(with(Wire().parameter(0x71, {0, 0, 0, 1})), DropReason::parameter_length);
  EXPECT_EQ(with(Wire().u16(0x71).u16(400).sentinel()), DropReason::parameter_length);
  EXPECT_EQ(with(Wire().parameter(0x71, Bytes(8, 0)).sentinel()), DropReason::parameter_content);
  EXPECT_EQ(with(Wire().parameter(0x70, Bytes(12, 0)).sentinel()), DropReason::parameter_content);
}

TEST(Data, NumberBeginsAtOne) {
  const auto with = [](std::int64_t number) {
    return drop_of(data_of(data_head(user_writer, number).raw(small_payload())));
  };
  EXPECT_EQ(with(1), passes);
  EXPECT_EQ(with(std::int64_t{1} << 40U), passes);  // a best-effort writer may be old
  EXPECT_EQ(with(0), DropReason::sequence_number);
  EXPECT_EQ(with(-1), DropReason::sequence_number);
  EXPECT_EQ(with(std::int64_t{1} << 62U), DropReason::sequence_number);
}

TEST(Data, PayloadHasAHeaderOfAKnownEncoding) {
  const auto with = [](const Bytes& payload) {
    return drop_of(data_of(data_head(user_writer).raw(payload)));
  };
  EXPECT_EQ(with({0, 1, 0, 0}), passes);
  EXPECT_EQ(with({0, 0x0b, 0, 0, 1, 2, 3}), passes);
  EXPECT_EQ(with({0, 0x1f, 0xff, 0}), passes);
  EXPECT_EQ(with({0x80, 1, 0, 0}), passes);  // a vendor's
  EXPECT_EQ(with({0, 0x20, 0, 0}), DropReason::payload);
  EXPECT_EQ(with({0x12, 1, 0, 0}), DropReason::payload);
  EXPECT_EQ(with({0, 1, 0}), DropReason::payload);
}

TEST(Data, HasEitherDataOrKey) {
  EXPECT_EQ(drop_of(data_of(data_head(user_writer).raw(small_payload()), with_data | with_key)),
            DropReason::payload);
}

/// The fixed part of a DATA_FRAG.
Wire fragment(std::uint32_t first, std::uint32_t count, std::uint32_t size, std::uint32_t sample) {
  return data_head(user_writer, 1, 28).u32(first).u16(count).u16(size).u32(sample);
}

std::optional<DropReason> drop_of_fragment(const Wire& content, std::uint32_t flags = 0) {
  return drop_of(Message().add(0x16, flags, content.bytes()).bytes());
}

TEST(Fragment, LiesWithinItsSample) {
  const Bytes thousand(1000, 0);
  EXPECT_EQ(drop_of_fragment(fragment(3, 1, 1000, 3000).raw(thousand)), passes);
  EXPECT_EQ(drop_of_fragment(fragment(3, 1, 1000, 2500).raw(Bytes(500, 0))), passes);
  EXPECT_EQ(drop_of_fragment(fragment(4, 1, 1000, 3000).raw(thousand)), DropReason::fragment);
  EXPECT_EQ(drop_of_fragment(fragment(3, 2, 1000, 3000).raw(Bytes(2000, 0))), DropReason::fragment);
  EXPECT_EQ(drop_of_fragment(fragment(0, 1, 1000, 3000).raw(thousand)), DropReason::fragment);
  EXPECT_EQ(drop_of_fragment(fragment(1, 0, 1000, 3000).raw(thousand)), DropReason::fragment);
  EXPECT_EQ(drop_of_fragment(fragment(1, 1, 0, 3000).raw(thousand)), DropReason::fragment);
  EXPECT_EQ(drop_of_fragment(fragment(1, 1, 1000, 0).raw(thousand)), DropReason::fragment);
}

TEST(Fragment, BringsAllThatItSays) {
  EXPECT_EQ(drop_of_fragment(fragment(1, 2, 1000, 3000).raw(Bytes(2000, 0))), passes);
  EXPECT_EQ(drop_of_fragment(fragment(1, 2, 1000, 3000).raw(Bytes(1996, 0))), DropReason::fragment);
}

TEST(Fragment, OfASampleBeyondTheLimitIsDropped) {
  const std::uint32_t most = Limits{}.sample_bytes;
  EXPECT_EQ(drop_of_fragment(fragment(1, 1, 1000, most).raw(Bytes(1000, 0))), passes);
  EXPECT_EQ(drop_of_fragment(fragment(1, 1, 1000, most + 1).raw(Bytes(1000, 0))),
            DropReason::sample_size);
  EXPECT_EQ(drop_of_fragment(fragment(1, 1, 1000, 0xffffffff).raw(Bytes(1000, 0))),
            DropReason::sample_size);
}

TEST(Fragment, WithInlineQosAndNoOffsetIsDropped) {
  const Wire content = data_head(user_writer, 1, 0).u32(1).u16(1).u16(1000).u32(3000);
  EXPECT_EQ(drop_of_fragment(Wire(content).raw(Bytes(1000, 0)), with_qos),
            DropReason::inline_qos_offset);
}

TEST(Fragment, OfAnAnnouncementBeyond64KiBIsDropped) {
  const auto with = [](std::uint32_t sample, std::uint32_t reader = 0) {
    const Wire head = data_head(sedp_writer, 1, 28, reader).u32(1).u16(1).u16(1000).u32(sample);
    return drop_of_fragment(Wire(head).raw(Bytes(1000, 0)));
  };
  EXPECT_EQ(with(65'536), passes);
  EXPECT_EQ(with(65'537), DropReason::sample_size);
  EXPECT_EQ(with(3000, 0x00000104), DropReason::discovery_payload);
}

TEST(Heartbeat, HasANumberRangeThatCanBe) {
  EXPECT_EQ(drop_of(heartbeat('a', 1, 0)), passes);  // nothing written yet
  EXPECT_EQ(drop_of(heartbeat('a', 7, 9)), passes);
  EXPECT_EQ(drop_of(heartbeat('a', 7, 5)), DropReason::sequence_number);
  EXPECT_EQ(drop_of(heartbeat('a', 0, 5)), DropReason::sequence_number);
  EXPECT_EQ(drop_of(heartbeat('a', 1, std::int64_t{1} << 60U)), DropReason::sequence_number);
}

TEST(Gap, CoversNotMoreThanAReaderCanWalk) {
  constexpr std::int64_t most = 1 << 20;
  EXPECT_EQ(drop_of(gap('a', 1, 1 + most)), passes);
  EXPECT_EQ(drop_of(gap('a', 1, 2 + most)), DropReason::gap_range);
  EXPECT_EQ(drop_of(gap('a', 1, std::int64_t{1} << 50U)), DropReason::gap_range);
  EXPECT_EQ(drop_of(gap('a', 1, std::int64_t{1} << 62U)), DropReason::sequence_number);
  EXPECT_EQ(drop_of(gap('a', 0, 5)), DropReason::sequence_number);
}

TEST(Gap, SetHasAtMost256Numbers) {
  EXPECT_EQ(drop_of(gap('a', 1, 2, 256)), passes);
  EXPECT_EQ(drop_of(gap('a', 1, 2, 257)), DropReason::sequence_number);
}

Wire acknack(std::int64_t base, std::uint32_t bits, std::size_t words) {
  return Wire().entity(0).entity(user_writer).number(base).u32(bits).zeros(words * 4).u32(1);
}

TEST(AckNack, BringsItsWholeSet) {
  const auto drop = [](const Wire& content) {
    return drop_of(Message().add(0x06, 0, content.bytes()).bytes());
  };
  EXPECT_EQ(drop(acknack(0, 0, 0)), passes);  // of a reader that has heard nothing
  EXPECT_EQ(drop(acknack(5, 256, 8)), passes);
  EXPECT_EQ(drop(acknack(5, 257, 9)), DropReason::sequence_number);
  EXPECT_EQ(drop(acknack(-1, 0, 0)), DropReason::sequence_number);
  EXPECT_EQ(drop(acknack(5, 64, 0)), DropReason::submessage_length);
}

TEST(NackFrag, BringsItsWholeSet) {
  const auto drop = [](std::int64_t number, std::uint32_t base, std::uint32_t bits,
                       std::size_t words) {
    return drop_of(Message()
                       .add(0x12, 0,
                            Wire()
                                .entity(0)
                                .entity(user_writer)
                                .number(number)
                                .u32(base)
                                .u32(bits)
                                .zeros(words * 4)
                                .u32(1)
                                .bytes())
                       .bytes());
  };
  EXPECT_EQ(drop(1, 1, 32, 1), passes);
  EXPECT_EQ(drop(1, 1, 64, 1), DropReason::submessage_length);
  EXPECT_EQ(drop(0, 1, 32, 1), DropReason::sequence_number);
  EXPECT_EQ(drop(1, 0, 32, 1), DropReason::sequence_number);
  EXPECT_EQ(drop(1, 1, 0xffffffff, 1), DropReason::sequence_number);
}

TEST(Sealed, ContentIsOpaque) {
  const Message message = Message()
                              .add(0x31, 0, Bytes(20, 1))
                              .add(0x30, 0, Bytes(100, 0xab))
                              .add(0x32, 0, Bytes(20, 2));
  EXPECT_EQ(drop_of(message.bytes()), passes);
}

}  // namespace
}  // namespace tocsin::rtps_filter
