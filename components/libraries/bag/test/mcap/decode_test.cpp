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

/// Decodes `record` cut at every byte: only the whole one may be understood.
template <class Decode>
void expect_whole_only(const Bytes& record, const Decode& decode) {
  const Span content = content_of(record);
  EXPECT_TRUE(decode(content));
  for (std::size_t size = 0; size < content.size; ++size) {
    // A copy of its own, so that a sanitizer sees each byte that is read beyond it.
    const Bytes part(content.data, content.data + size);
    EXPECT_FALSE(decode(Span{part.data(), part.size()})) << size << " of " << content.size;
  }
}

template <class Record>
Bytes encoded(const Record& record) {
  Bytes bytes;
  put(bytes, record);
  return bytes;
}

TEST(Decode, Header) {
  const Bytes record = encoded(Header{"ros2", "tocsin"});
  EXPECT_EQ(decode_header(content_of(record))->profile, "ros2");
  EXPECT_EQ(decode_header(content_of(record))->library, "tocsin");
  expect_whole_only(record, decode_header);
}

TEST(Decode, Schema) {
  const Bytes record = encoded(Schema{0x1234, "a/B", "ros2msg", "int32 x"});
  const auto schema = decode_schema(content_of(record));
  ASSERT_TRUE(schema);
  EXPECT_EQ(schema->id, 0x1234);
  EXPECT_EQ(schema->name, "a/B");
  EXPECT_EQ(schema->encoding, "ros2msg");
  EXPECT_EQ(schema->data, "int32 x");
  expect_whole_only(record, decode_schema);
}

TEST(Decode, SchemaOfIdZeroIsNone) {
  EXPECT_FALSE(decode_schema(content_of(encoded(Schema{0, "a/B", "", ""}))));
}

TEST(Decode, Channel) {
  const Bytes record = encoded(Channel{7, 8, "/topic", "cdr", {{"a", "b"}, {"c", ""}}});
  const auto channel = decode_channel(content_of(record));
  ASSERT_TRUE(channel);
  EXPECT_EQ(channel->id, 7);
  EXPECT_EQ(channel->schema_id, 8);
  EXPECT_EQ(channel->topic, "/topic");
  EXPECT_EQ(channel->message_encoding, "cdr");
  EXPECT_EQ(channel->metadata, (KeyValues{{"a", "b"}, {"c", ""}}));
  expect_whole_only(record, decode_channel);
}

TEST(Decode, MessageNeedsItsHeadOnly) {
  const Bytes data{1, 2, 3};
  const Bytes record =
      encoded(Message{3, 0xfffffffe, ~std::uint64_t{0}, 5, data.data(), data.size()});
  const auto message = decode_message(content_of(record));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel_id, 3);
  EXPECT_EQ(message->sequence, 0xfffffffeU);
  EXPECT_EQ(message->log_time_ns, ~std::uint64_t{0});
  EXPECT_EQ(message->publish_time_ns, 5U);
  EXPECT_EQ(Bytes(message->data, message->data + message->size), data);
  constexpr std::size_t head = 22;
  EXPECT_TRUE(decode_message({record.data() + record_head, head}));
  EXPECT_FALSE(decode_message({record.data() + record_head, head - 1}));
}

TEST(Decode, AttachmentWithAndWithoutAChecksum) {
  for (const bool crc : {true, false}) {
    Bytes record;
    put(record, Attachment{1, 2, "name", "type", "data"}, crc);
    const auto attachment = decode_attachment(content_of(record));
    ASSERT_TRUE(attachment);
    EXPECT_EQ(attachment->log_time_ns, 1U);
    EXPECT_EQ(attachment->create_time_ns, 2U);
    EXPECT_EQ(attachment->name, "name");
    EXPECT_EQ(attachment->media_type, "type");
    EXPECT_EQ(attachment->data, "data");
    expect_whole_only(record, decode_attachment);
    record[record_head] ^= 1U;
    EXPECT_EQ(decode_attachment(content_of(record)).has_value(), !crc);
  }
}

TEST(Decode, Metadata) {
  const Bytes record = encoded(Metadata{"name", {{"k", "v"}}});
  EXPECT_EQ(decode_metadata(content_of(record))->values, (KeyValues{{"k", "v"}}));
  expect_whole_only(record, decode_metadata);
}

TEST(Decode, ChunkIndex) {
  const Bytes record = encoded(ChunkIndex{1, 2, 3, 4, {{5, 6}, {7, 8}}, 9, "zstd", 10, 11, false});
  const auto index = decode_chunk_index(content_of(record));
  ASSERT_TRUE(index);
  EXPECT_EQ(index->start_ns, 1U);
  EXPECT_EQ(index->end_ns, 2U);
  EXPECT_EQ(index->offset, 3U);
  EXPECT_EQ(index->length, 4U);
  EXPECT_EQ(index->message_indexes.at(1), std::make_pair(std::uint16_t{7}, std::uint64_t{8}));
  EXPECT_EQ(index->message_index_length, 9U);
  EXPECT_EQ(index->compression, "zstd");
  EXPECT_EQ(index->compressed_size, 10U);
  EXPECT_EQ(index->uncompressed_size, 11U);
  expect_whole_only(record, decode_chunk_index);
}

TEST(Decode, AttachmentIndexAndMetadataIndex) {
  const Bytes attachment = encoded(AttachmentIndex{1, 2, 3, 4, 5, "name", "type"});
  EXPECT_EQ(decode_attachment_index(content_of(attachment))->data_size, 5U);
  EXPECT_EQ(decode_attachment_index(content_of(attachment))->media_type, "type");
  expect_whole_only(attachment, decode_attachment_index);
  const Bytes metadata = encoded(MetadataIndex{1, 2, "name"});
  EXPECT_EQ(decode_metadata_index(content_of(metadata))->length, 2U);
  EXPECT_EQ(decode_metadata_index(content_of(metadata))->name, "name");
  expect_whole_only(metadata, decode_metadata_index);
}

TEST(Decode, Statistics) {
  const Bytes record = encoded(mcap::Statistics{1, 2, 3, 4, 5, 6, 7, 8, {{9, 10}, {11, 12}}});
  const auto statistics = decode_statistics(content_of(record));
  ASSERT_TRUE(statistics);
  EXPECT_EQ(statistics->message_count, 1U);
  EXPECT_EQ(statistics->schema_count, 2U);
  EXPECT_EQ(statistics->channel_count, 3U);
  EXPECT_EQ(statistics->attachment_count, 4U);
  EXPECT_EQ(statistics->metadata_count, 5U);
  EXPECT_EQ(statistics->chunk_count, 6U);
  EXPECT_EQ(statistics->start_ns, 7U);
  EXPECT_EQ(statistics->end_ns, 8U);
  EXPECT_EQ(statistics->channel_message_counts.at(11), 12U);
  expect_whole_only(record, decode_statistics);
}

TEST(Cursor, RefusesALengthThatIsNotThere) {
  const Bytes bytes{0xff, 0xff, 0xff, 0xff, 'a'};
  Cursor text({bytes.data(), bytes.size()});
  EXPECT_EQ(text.text(), "");
  EXPECT_FALSE(text.good());
  Cursor pairs({bytes.data(), bytes.size()});
  EXPECT_TRUE(pairs.key_values().empty());
  EXPECT_FALSE(pairs.good());
}

TEST(Cursor, RefusesAPairThatEndsWithinItself) {
  Bytes bytes;
  put_number(bytes, 6, 4);
  put_text(bytes, "k");
  bytes.push_back(0);  // a byte of the value's length
  Cursor sut({bytes.data(), bytes.size()});
  (void)sut.key_values();
  EXPECT_FALSE(sut.good());
}

TEST(Cursor, GivesNothingAfterWhatWasNotThere) {
  const Bytes bytes{1, 2, 3};
  Cursor sut({bytes.data(), bytes.size()});
  EXPECT_EQ(sut.u32(), 0U);
  EXPECT_EQ(sut.u8(), 0U);
  EXPECT_FALSE(sut.good());
}

TEST(Cursor, ReadsNumbersOfEachSize) {
  const Bytes bytes{1, 2, 0, 3, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0x80};
  Cursor sut({bytes.data(), bytes.size()});
  EXPECT_EQ(sut.u8(), 1U);
  EXPECT_EQ(sut.u16(), 2U);
  EXPECT_EQ(sut.u32(), 3U);
  EXPECT_EQ(sut.u64(), 0x8000000000000004U);
  EXPECT_EQ(sut.left(), 0U);
  EXPECT_TRUE(sut.good());
}

TEST(Crc, IsThatOfIeee8023) {
  const std::string check = "123456789";  // the usual check value of CRC catalogues
  const Bytes bytes(check.begin(), check.end());
  EXPECT_EQ(crc32({bytes.data(), bytes.size()}), 0xcbf43926U);
  EXPECT_EQ(crc32({bytes.data() + 4, 5}, crc32({bytes.data(), 4})), 0xcbf43926U);
}

}  // namespace
}  // namespace tocsin::mcap
