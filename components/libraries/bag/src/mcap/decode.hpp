// SPDX-License-Identifier: Apache-2.0
// What records say. Empty when a record is too short for its fields.
#pragma once

#include <optional>

#include "cursor.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

[[nodiscard]] std::optional<Header> decode_header(Span content);
[[nodiscard]] std::optional<Schema> decode_schema(Span content);
[[nodiscard]] std::optional<Channel> decode_channel(Span content);
/// Its bytes are those of `content`.
[[nodiscard]] std::optional<Message> decode_message(Span content);
/// Also empty when the checksum is wrong.
[[nodiscard]] std::optional<Attachment> decode_attachment(Span content);
[[nodiscard]] std::optional<Metadata> decode_metadata(Span content);
[[nodiscard]] std::optional<ChunkIndex> decode_chunk_index(Span content);
[[nodiscard]] std::optional<AttachmentIndex> decode_attachment_index(Span content);
[[nodiscard]] std::optional<MetadataIndex> decode_metadata_index(Span content);
[[nodiscard]] std::optional<Statistics> decode_statistics(Span content);

struct Footer {
  std::uint64_t summary_start = 0;  ///< 0: the file has no summary
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;  ///< 0: not computed
};
[[nodiscard]] std::optional<Footer> decode_footer(Span content);

/// The fields of a chunk in front of its records.
struct ChunkHead {
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: not computed
  std::string compression;
  std::uint64_t compressed_size = 0;
};
/// Moves `cursor` to the records.
[[nodiscard]] std::optional<ChunkHead> decode_chunk_head(Cursor& cursor);

}  // namespace tocsin::mcap
