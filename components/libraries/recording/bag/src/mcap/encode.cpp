// SPDX-License-Identifier: Apache-2.0
#include "encode.hpp"

#include <endian.h>
#include <zlib.h>

#include <cstring>

#include "records.hpp"

namespace tocsin::mcap {
namespace {

/// The lowest `bytes` of a number, little-endian.
void store(std::uint8_t* to, std::uint64_t value, std::size_t bytes) {
  const std::uint64_t little = htole64(value);
  std::memcpy(to, &little, bytes);
}

template <class Number, class = std::enable_if_t<std::is_unsigned_v<Number>>>
void put_field(Bytes& to, Number value) {
  put_number(to, value, sizeof value);
}

void put_field(Bytes& to, const std::string& text) { put_text(to, text); }

/// Pairs behind their length in bytes.
template <class Pairs, typename Pairs::const_iterator* = nullptr>
void put_field(Bytes& to, const Pairs& values) {
  Bytes pairs;
  for (const auto& [key, value] : values) {
    put_field(pairs, key);
    put_field(pairs, value);
  }
  put_number(to, pairs.size(), 4);
  to.insert(to.end(), pairs.begin(), pairs.end());
}

template <class Record>
void put_fields(Bytes& to, const Record& record) {
  std::apply([&to](const auto&... field) { (put_field(to, field), ...); }, fields_of(record));
}

template <class Record>
void put_record(Bytes& to, Opcode opcode, const Record& record) {
  const std::size_t begin = begin_record(to, opcode);
  put_fields(to, record);
  end_record(to, begin);
}

}  // namespace

void put_number(Bytes& to, std::uint64_t value, std::size_t bytes) {
  std::array<std::uint8_t, 8> field{};
  store(field.data(), value, bytes);
  to.insert(to.end(), field.data(), field.data() + bytes);
}

void put_text(Bytes& to, const std::string& text) {
  put_number(to, text.size(), 4);
  to.insert(to.end(), text.begin(), text.end());
}

std::size_t begin_record(Bytes& to, Opcode opcode) {
  to.push_back(static_cast<std::uint8_t>(opcode));
  put_number(to, 0, 8);
  return to.size();
}

void end_record(Bytes& to, std::size_t begin, std::uint64_t more) {
  store(to.data() + begin - 8, to.size() - begin + more, 8);
}

void put(Bytes& to, const Header& record) { put_record(to, Opcode::header, record); }
void put(Bytes& to, const Schema& record) { put_record(to, Opcode::schema, record); }
void put(Bytes& to, const Channel& record) { put_record(to, Opcode::channel, record); }
void put(Bytes& to, const Metadata& record) { put_record(to, Opcode::metadata, record); }
void put(Bytes& to, const ChunkIndex& record) { put_record(to, Opcode::chunk_index, record); }
void put(Bytes& to, const AttachmentIndex& record) {
  put_record(to, Opcode::attachment_index, record);
}
void put(Bytes& to, const MetadataIndex& record) { put_record(to, Opcode::metadata_index, record); }
void put(Bytes& to, const Statistics& record) { put_record(to, Opcode::statistics, record); }

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
  put_fields(to, attachment);
  put_number(to, attachment.data.size(), 8);
  to.insert(to.end(), attachment.data.begin(), attachment.data.end());
  put_number(to, crc ? crc32({to.data() + begin, to.size() - begin}) : 0, 4);
  end_record(to, begin);
}

std::uint32_t crc32(Span bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(::crc32_z(before, bytes.data, bytes.size));
}

}  // namespace tocsin::mcap
