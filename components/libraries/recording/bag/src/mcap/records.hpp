// SPDX-License-Identifier: Apache-2.0
// The fields of each record in the order of the file: one table for those who write and who read.
#pragma once

#include <tuple>
#include <type_traits>

#include "mcap/format.hpp"

namespace tocsin::mcap {

struct Footer {
  std::uint64_t summary_start = 0;  ///< 0: the file has no summary
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;  ///< 0: not computed
};

/// The fields of a chunk in front of its records.
struct ChunkHead {
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: not computed
  std::string compression;
  std::uint64_t compressed_size = 0;
};

/// References to the fields, a number as wide as in the file. Of Message and Attachment those in
/// front of their data.
template <class Record>
auto fields_of(Record& r) {
  using R = std::remove_const_t<Record>;
  if constexpr (std::is_same_v<R, Header>) {
    return std::tie(r.profile, r.library);
  } else if constexpr (std::is_same_v<R, Schema>) {
    return std::tie(r.id, r.name, r.encoding, r.data);
  } else if constexpr (std::is_same_v<R, Channel>) {
    return std::tie(r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
  } else if constexpr (std::is_same_v<R, Message>) {
    return std::tie(r.channel_id, r.sequence, r.log_time_ns, r.publish_time_ns);
  } else if constexpr (std::is_same_v<R, Attachment>) {
    return std::tie(r.log_time_ns, r.create_time_ns, r.name, r.media_type);
  } else if constexpr (std::is_same_v<R, Metadata>) {
    return std::tie(r.name, r.values);
  } else if constexpr (std::is_same_v<R, ChunkHead>) {
    return std::tie(r.start_ns, r.end_ns, r.uncompressed_size, r.uncompressed_crc, r.compression,
                    r.compressed_size);
  } else if constexpr (std::is_same_v<R, ChunkIndex>) {
    return std::tie(r.start_ns, r.end_ns, r.offset, r.length, r.message_indexes,
                    r.message_index_length, r.compression, r.compressed_size, r.uncompressed_size);
  } else if constexpr (std::is_same_v<R, AttachmentIndex>) {
    return std::tie(r.offset, r.length, r.log_time_ns, r.create_time_ns, r.data_size, r.name,
                    r.media_type);
  } else if constexpr (std::is_same_v<R, MetadataIndex>) {
    return std::tie(r.offset, r.length, r.name);
  } else if constexpr (std::is_same_v<R, Statistics>) {
    return std::tie(r.message_count, r.schema_count, r.channel_count, r.attachment_count,
                    r.metadata_count, r.chunk_count, r.start_ns, r.end_ns,
                    r.channel_message_counts);
  } else {
    return std::tie(r.summary_start, r.summary_offset_start, r.summary_crc);
  }
}

}  // namespace tocsin::mcap
