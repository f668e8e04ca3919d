// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "cursor.hpp"
#include "decode.hpp"
#include "encode.hpp"
#include "mcap/byte_source.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

/// A chunk in memory.
struct LoadedChunk {
  enum class State {
    whole,   ///< and its checksum is right, if it has one
    cut,     ///< the file ends in it; what came before that is there
    damaged  ///< its records cannot be trusted, or unpacked
  };
  State state = State::damaged;
  ChunkHead head;
  Span compressed;
  Span records;
  Bytes content;   ///< of the chunk's record
  Bytes unpacked;  ///< empty when it was not compressed
};

/// Loads the record at `offset` of the file, of which `length` bytes are there. Records that stand
/// outside of chunks (`is_plain`) are taken as they are.
void load_chunk(ByteSource& source, const ChunkIndex& index, LoadedChunk& chunk);

/// Calls `on_record(opcode, content, offset)` for each whole record of `records`.
template <class OnRecord>
void for_each_record(Span records, const OnRecord& on_record) {
  Cursor cursor(records);
  while (cursor.left() >= record_head) {
    const std::size_t offset = cursor.at();
    const auto opcode = static_cast<Opcode>(cursor.number(1));
    const Span content = cursor.take(cursor.number(8));
    if (!cursor.good()) return;
    on_record(opcode, content, offset);
  }
}

}  // namespace tocsin::mcap
