// SPDX-License-Identifier: Apache-2.0
#include "encode.hpp"

#include <endian.h>
#include <zlib.h>

#include <cstring>

namespace tocsin::mcap {
namespace {

/// The lowest `bytes` of a number, little-endian.
void store(std::uint8_t* to, std::uint64_t value, std::size_t bytes) {
  const std::uint64_t little = htole64(value);
  std::memcpy(to, &little, bytes);
}

void put_u16(Bytes& to, std::uint16_t value) { put_number(to, value, 2); }
void put_u32(Bytes& to, std::uint64_t value) { put_number(to, value, 4); }
void put_u64(Bytes& to, std::uint64_t value) { put_number(to, value, 8); }

void put_key_values(Bytes& to, const KeyValues& values) {
  Bytes pairs;
  for (const auto& [key, value] : values) {
    put_text(pairs, key);
    put_text(pairs, value);
  }
  put_u32(to, pairs.size());
  to.insert(to.end(), pairs.begin(), pairs.end());
}

}  // namespace

void put_number(Bytes& to, std::uint64_t value, std::size_t bytes) {
  std::array<std::uint8_t, 8> field{};
  store(field.data(), value, bytes);
  to.insert(to.end(), field.data(), field.data() + bytes);
}

void put_text(Bytes& to, const std::string& text) {
  put_u32(to, text.size());
  to.insert(to.end(), text.begin(), text.end());
}

std::size_t begin_record(Bytes& to, Opcode opcode) {
  to.push_back(static_cast<std::uint8_t>(opcode));
  put_u64(to, 0);
  return to.size();
}

void end_record(Bytes& to, std::size_t begin, std::uint64_t more) {
  store(to.data() + begin - 8, to.size() - begin + more, 8);
}

void put(Bytes& to, const Header& header) {
  const std::size_t begin = begin_record(to, Opcode::header);
  put_text(to, header.profile);
  put_text(to, header.library);
  end_record(to, begin);
}

void put(Bytes& to, const Schema& schema) {
  const std::size_t begin = begin_record(to, Opcode::schema);
  put_u16(to, schema.id);
  put_text(to, schema.name);
  put_text(to, schema.encoding);
  put_text(to, schema.data);
  end_record(to, begin);
}

void put(Bytes& to, const Channel& channel) {
  const std::size_t begin = begin_record(to, Opcode::channel);
  put_u16(to, channel.id);
  put_u16(to, channel.schema_id);
  put_text(to, channel.topic);
  put_text(to, channel.message_encoding);
  put_key_values(to, channel.metadata);
  end_record(to, begin);
}

void put(Bytes& to, const Message& message) {
  constexpr std::size_t fields = 22;
  std::array<std::uint8_t, record_head + fields> head{};
  std::size_t at = 0;
  const auto number = [&](std::uint64_t value, std::size_t bytes) {
    store(head.data() + at, value, bytes);
    at += bytes;
  };
  number(static_cast<std::uint8_t>(Opcode::message), 1);
  number(fields + message.size, 8);
  number(message.channel_id, 2);
  number(message.sequence, 4);
  number(message.log_time_ns, 8);
  number(message.publish_time_ns, 8);
  to.insert(to.end(), head.begin(), head.end());
  to.insert(to.end(), message.data, message.data + message.size);
}

void put(Bytes& to, const Attachment& attachment, bool crc) {
  const std::size_t begin = begin_record(to, Opcode::attachment);
  put_u64(to, attachment.log_time_ns);
  put_u64(to, attachment.create_time_ns);
  put_text(to, attachment.name);
  put_text(to, attachment.media_type);
  put_u64(to, attachment.data.size());
  to.insert(to.end(), attachment.data.begin(), attachment.data.end());
  put_u32(to, crc ? crc32({to.data() + begin, to.size() - begin}) : 0);
  end_record(to, begin);
}

void put(Bytes& to, const Metadata& metadata) {
  const std::size_t begin = begin_record(to, Opcode::metadata);
  put_text(to, metadata.name);
  put_key_values(to, metadata.values);
  end_record(to, begin);
}

void put(Bytes& to, const ChunkIndex& index) {
  constexpr std::size_t bytes_of_entry = 10;
  const std::size_t begin = begin_record(to, Opcode::chunk_index);
  put_u64(to, index.start_ns);
  put_u64(to, index.end_ns);
  put_u64(to, index.offset);
  put_u64(to, index.length);
  put_u32(to, index.message_indexes.size() * bytes_of_entry);
  for (const auto& [channel, offset] : index.message_indexes) {
    put_u16(to, channel);
    put_u64(to, offset);
  }
  put_u64(to, index.message_index_length);
  put_text(to, index.compression);
  put_u64(to, index.compressed_size);
  put_u64(to, index.uncompressed_size);
  end_record(to, begin);
}

void put(Bytes& to, const AttachmentIndex& index) {
  const std::size_t begin = begin_record(to, Opcode::attachment_index);
  put_u64(to, index.offset);
  put_u64(to, index.length);
  put_u64(to, index.log_time_ns);
  put_u64(to, index.create_time_ns);
  put_u64(to, index.data_size);
  put_text(to, index.name);
  put_text(to, index.media_type);
  end_record(to, begin);
}

void put(Bytes& to, const MetadataIndex& index) {
  const std::size_t begin = begin_record(to, Opcode::metadata_index);
  put_u64(to, index.offset);
  put_u64(to, index.length);
  put_text(to, index.name);
  end_record(to, begin);
}

void put(Bytes& to, const Statistics& statistics) {
  constexpr std::size_t bytes_of_count = 10;
  const std::size_t begin = begin_record(to, Opcode::statistics);
  put_u64(to, statistics.message_count);
  put_u16(to, statistics.schema_count);
  put_u32(to, statistics.channel_count);
  put_u32(to, statistics.attachment_count);
  put_u32(to, statistics.metadata_count);
  put_u32(to, statistics.chunk_count);
  put_u64(to, statistics.start_ns);
  put_u64(to, statistics.end_ns);
  put_u32(to, statistics.channel_message_counts.size() * bytes_of_count);
  for (const auto& [channel, count] : statistics.channel_message_counts) {
    put_u16(to, channel);
    put_u64(to, count);
  }
  end_record(to, begin);
}

std::uint32_t crc32(Span bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(::crc32_z(before, bytes.data, bytes.size));
}

}  // namespace tocsin::mcap
