// SPDX-License-Identifier: Apache-2.0
// What an MCAP file is made of: https://mcap.dev/spec. All times are nanoseconds; in files of ours
// since the Unix epoch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tocsin::mcap {

/// First and last bytes of a file.
inline constexpr std::array<std::uint8_t, 8> magic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

enum class Opcode : std::uint8_t {
  header = 1,
  footer,
  schema,
  channel,
  message,
  chunk,
  message_index,
  chunk_index,
  attachment,
  attachment_index,
  statistics,
  metadata,
  metadata_index,
  summary_offset,
  data_end
};

/// Of a chunk; lz4 is the frame format.
enum class Compression { none, lz4, zstd };
/// `none`, `lz4`, `zstd`.
constexpr std::array<const char*, 3> words_of(Compression) { return {"none", "lz4", "zstd"}; }

using KeyValues = std::map<std::string, std::string>;
using Bytes = std::vector<std::uint8_t>;

struct Header {
  std::string profile;
  std::string library;
};

/// How messages are to be understood. Id 0 is none's.
struct Schema {
  std::uint16_t id = 0;
  std::string name;
  std::string encoding;
  std::string data;
};

/// Messages of one writer or topic.
struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  ///< 0: none
  std::string topic;
  std::string message_encoding;
  KeyValues metadata;
};

/// A message; its bytes belong to somebody else.
struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

struct Attachment {
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::string name;
  std::string media_type;
  std::string data;
};

struct Metadata {
  std::string name;
  KeyValues values;
};

struct AttachmentIndex {
  std::uint64_t offset = 0;  ///< [byte] of the record in the file
  std::uint64_t length = 0;  ///< [byte] of the record, opcode and length included
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::uint64_t data_size = 0;  ///< [byte]
  std::string name;
  std::string media_type;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
};

/// Where messages lie: a chunk, or, in a file without chunks, records that follow each other.
struct ChunkIndex {
  std::uint64_t start_ns = 0;  ///< of its earliest message, by log time; 0: it has none
  std::uint64_t end_ns = 0;
  std::uint64_t offset = 0;  ///< [byte] of the record in the file
  std::uint64_t length = 0;  ///< [byte] of the record, opcode and length included
  /// Of the MessageIndex of each channel; empty: not known which channels it has.
  std::vector<std::pair<std::uint16_t, std::uint64_t>> message_indexes;
  std::uint64_t message_index_length = 0;  ///< [byte] of all MessageIndex records behind it
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
  bool is_plain = false;  ///< records outside of chunks; such an index is in no file
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t start_ns = 0;  ///< log time of the earliest message; 0: there is none
  std::uint64_t end_ns = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};

}  // namespace tocsin::mcap
