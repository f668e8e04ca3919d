// SPDX-License-Identifier: Apache-2.0
#include "decode.hpp"

#include "encode.hpp"

namespace tocsin::mcap {
namespace {

/// `value` when all of its fields were there.
template <class T>
std::optional<T> checked(const Cursor& cursor, T value) {
  if (!cursor.good()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Header> decode_header(Span content) {
  Cursor c(content);
  Header header;
  header.profile = c.text();
  header.library = c.text();
  return checked(c, std::move(header));
}

std::optional<Schema> decode_schema(Span content) {
  Cursor c(content);
  Schema schema;
  schema.id = c.u16();
  schema.name = c.text();
  schema.encoding = c.text();
  schema.data = c.text();
  if (schema.id == 0) return std::nullopt;
  return checked(c, std::move(schema));
}

std::optional<Channel> decode_channel(Span content) {
  Cursor c(content);
  Channel channel;
  channel.id = c.u16();
  channel.schema_id = c.u16();
  channel.topic = c.text();
  channel.message_encoding = c.text();
  channel.metadata = c.key_values();
  return checked(c, std::move(channel));
}

std::optional<Message> decode_message(Span content) {
  Cursor c(content);
  Message message;
  message.channel_id = c.u16();
  message.sequence = c.u32();
  message.log_time_ns = c.u64();
  message.publish_time_ns = c.u64();
  const Span data = c.take(c.left());
  message.data = data.data;
  message.size = data.size;
  return checked(c, message);
}

std::optional<Attachment> decode_attachment(Span content) {
  Cursor c(content);
  Attachment attachment;
  attachment.log_time_ns = c.u64();
  attachment.create_time_ns = c.u64();
  attachment.name = c.text();
  attachment.media_type = c.text();
  const Span data = c.take(c.u64());
  const std::size_t covered = c.at();
  const std::uint32_t crc = c.u32();
  if (!c.good() || (crc != 0 && crc != crc32({content.data, covered}))) return std::nullopt;
  attachment.data.assign(reinterpret_cast<const char*>(data.data), data.size);
  return attachment;
}

std::optional<Metadata> decode_metadata(Span content) {
  Cursor c(content);
  Metadata metadata;
  metadata.name = c.text();
  metadata.values = c.key_values();
  return checked(c, std::move(metadata));
}

std::optional<ChunkIndex> decode_chunk_index(Span content) {
  Cursor c(content);
  ChunkIndex index;
  index.start_ns = c.u64();
  index.end_ns = c.u64();
  index.offset = c.u64();
  index.length = c.u64();
  Cursor offsets(c.take(c.u32()));
  while (offsets.good() && offsets.left() > 0) {
    const std::uint16_t channel = offsets.u16();
    index.message_indexes.emplace_back(channel, offsets.u64());
  }
  index.message_index_length = c.u64();
  index.compression = c.text();
  index.compressed_size = c.u64();
  index.uncompressed_size = c.u64();
  if (!offsets.good()) return std::nullopt;
  return checked(c, std::move(index));
}

std::optional<AttachmentIndex> decode_attachment_index(Span content) {
  Cursor c(content);
  AttachmentIndex index;
  index.offset = c.u64();
  index.length = c.u64();
  index.log_time_ns = c.u64();
  index.create_time_ns = c.u64();
  index.data_size = c.u64();
  index.name = c.text();
  index.media_type = c.text();
  return checked(c, std::move(index));
}

std::optional<MetadataIndex> decode_metadata_index(Span content) {
  Cursor c(content);
  MetadataIndex index;
  index.offset = c.u64();
  index.length = c.u64();
  index.name = c.text();
  return checked(c, std::move(index));
}

std::optional<Statistics> decode_statistics(Span content) {
  Cursor c(content);
  Statistics statistics;
  statistics.message_count = c.u64();
  statistics.schema_count = c.u16();
  statistics.channel_count = c.u32();
  statistics.attachment_count = c.u32();
  statistics.metadata_count = c.u32();
  statistics.chunk_count = c.u32();
  statistics.start_ns = c.u64();
  statistics.end_ns = c.u64();
  Cursor counts(c.take(c.u32()));
  while (counts.good() && counts.left() > 0) {
    const std::uint16_t channel = counts.u16();
    statistics.channel_message_counts[channel] = counts.u64();
  }
  if (!counts.good()) return std::nullopt;
  return checked(c, std::move(statistics));
}

std::optional<Footer> decode_footer(Span content) {
  Cursor c(content);
  Footer footer;
  footer.summary_start = c.u64();
  footer.summary_offset_start = c.u64();
  footer.summary_crc = c.u32();
  return checked(c, footer);
}

std::optional<ChunkHead> decode_chunk_head(Cursor& c) {
  ChunkHead head;
  head.start_ns = c.u64();
  head.end_ns = c.u64();
  head.uncompressed_size = c.u64();
  head.uncompressed_crc = c.u32();
  head.compression = c.text();
  head.compressed_size = c.u64();
  return checked(c, std::move(head));
}

}  // namespace tocsin::mcap
