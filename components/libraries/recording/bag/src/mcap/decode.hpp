// SPDX-License-Identifier: Apache-2.0
// What records say. Empty when a record is too short for its fields.
#pragma once

#include <optional>

#include "cursor.hpp"
#include "records.hpp"

namespace tocsin::mcap {

/// Of a record's content. A message's bytes are those of `content`; empty also for a schema of id 0
/// and an attachment whose checksum is wrong.
template <class Record>
[[nodiscard]] std::optional<Record> decode(Span content);
template <>
std::optional<Schema> decode(Span content);
template <>
std::optional<Message> decode(Span content);
template <>
std::optional<Attachment> decode(Span content);

/// Moves `cursor` to the records.
[[nodiscard]] std::optional<ChunkHead> decode_chunk_head(Cursor& cursor);

}  // namespace tocsin::mcap
