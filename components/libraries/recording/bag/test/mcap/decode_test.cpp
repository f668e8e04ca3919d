// SPDX-License-Identifier: Apache-2.0
#include "decode.hpp"

#include <gtest/gtest.h>

#include "encode.hpp"

namespace tocsin::mcap {
namespace {

/// The content of the one record of `record`.
Span content_of(const Bytes& record) {
  return {record.data() + record_head, record.size() - record_head};
}

/// What is decoded of `record` gives the same bytes again; of `record` cut at any byte nothing is.
template <class Record>
void expect_round_trip(const Record& given) {
  Bytes record;
  put(record, given);
  const Span content = content_of(record);
  const auto decoded = decode<Record>(content);
  ASSERT_TRUE(decoded);
  Bytes again;
  put(again, *decoded);
  EXPECT_EQ(again, record);
  for (std::size_t size = 0; size < content.size; ++size) {
    // A copy of its own, so that a sanitizer sees each byte that is read beyond it.
    const Bytes part(content.data, content.data + size);
    EXPECT_FALSE(decode<Record>({part.data(), part.size()})) << size << " of " << content.size;
  }
}

TEST(Decode, EachRecordIsReadAsItWasWrittenAndOnlyWhole) {
  expect_round_trip(Header{"ros2", "tocsin"});
  expect_round_trip(Schema{0x1234, "a/B", "ros2msg", "int32 x"});
  expect_round_trip(Channel{7, 8, "/topic", "cdr", {{"a", "b"}, {"c", ""}}});
  expect_round_trip(Metadata{"name", {{"k", "v"}}});
  expect_round_trip(ChunkIndex{1, 2, 3, 4, {{5, 6}, {7, 8}}, 9, "zstd", 10, 11, false});
  expect_round_trip(AttachmentIndex{1, 2, 3, 4, 5, "name", "type"});
  expect_round_trip(MetadataIndex{1, 2, "name"});
  expect_round_trip(mcap::Statistics{1, 2, 3, 4, 5, 6, 7, 8, {{9, 10}, {11, 12}}});
}

TEST(Decode, SchemaOfIdZeroIsNone) {
  Bytes record;
  put(record, Schema{0, "a/B", "", ""});
  EXPECT_FALSE(decode<Schema>(content_of(record)));
}

TEST(Decode, MessageNeedsItsHeadOnly) {
  const Bytes data{1, 2, 3};
  Bytes record;
  put(record, Message{3, 0xfffffffe, ~std::uint64_t{0}, 5, data.data(), data.size()});
  const auto message = decode<Message>(content_of(record));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel_id, 3);
  EXPECT_EQ(message->sequence, 0xfffffffeU);
  EXPECT_EQ(message->log_time_ns, ~std::uint64_t{0});
  EXPECT_EQ(message->publish_time_ns, 5U);
  EXPECT_EQ(Bytes(message->data, message->data + message->size), data);
  constexpr std::size_t head = 22;
  EXPECT_TRUE(decode<Message>({record.data() + record_head, head}));
  EXPECT_FALSE(decode<Message>({record.data() + record_head, head - 1}));
}

TEST(Decode, AttachmentWithAndWithoutAChecksum) {
  for (const bool crc : {true, false}) {
    Bytes record;
    put(record, Attachment{1, 2, "name", "type", "data"}, crc);
    const auto attachment = decode<Attachment>(content_of(record));
    ASSERT_TRUE(attachment);
    Bytes again;
    put(again, *attachment, crc);
    EXPECT_EQ(again, record);
    EXPECT_FALSE(
        decode<Attachment>({record.data() + record_head, record.size() - record_head - 1}));
    record[record_head] ^= 1U;
    EXPECT_EQ(decode<Attachment>(content_of(record)).has_value(), !crc);
  }
}

TEST(Decode, PairsWhoseLengthLiesAreNone) {
  const Bytes beyond{1, 0, 0, 0, 'a', 0xff, 0xff, 0xff, 0xff, 'k'};
  EXPECT_FALSE(decode<Metadata>({beyond.data(), beyond.size()}));
  Bytes within{1, 0, 0, 0, 'a'};
  put_number(within, 6, 4);
  put_text(within, "k");
  within.push_back(0);  // a byte of the value's length
  EXPECT_FALSE(decode<Metadata>({within.data(), within.size()}));
}

TEST(Cursor, GivesNothingAfterWhatWasNotThere) {
  const Bytes bytes{1, 2, 3};
  Cursor sut({bytes.data(), bytes.size()});
  EXPECT_EQ(sut.number(4), 0U);
  EXPECT_EQ(sut.number(1), 0U);
  EXPECT_FALSE(sut.good());
}

TEST(Crc, IsThatOfIeee8023) {
  const std::string check = "123456789";  // the usual check value of CRC catalogues
  const Bytes bytes(check.begin(), check.end());
  EXPECT_EQ(crc32({bytes.data(), bytes.size()}), 0xcbf43926U);
  EXPECT_EQ(crc32({bytes.data() + 4, 5}, crc32({bytes.data(), 4})), 0xcbf43926U);
}

}  // namespace
}  // namespace tocsin::mcap
