// SPDX-License-Identifier: Apache-2.0
#include "chunk.hpp"

#include <algorithm>

#include "compression.hpp"

namespace tocsin::mcap {
namespace {

LoadedChunk::State unpack_chunk(LoadedChunk& chunk) {
  using State = LoadedChunk::State;
  Cursor cursor({chunk.content.data(), chunk.content.size()});
  const auto head = decode_chunk_head(cursor);
  if (!head) return State::cut;
  chunk.head = *head;
  const bool cut = head->compressed_size > cursor.left();
  chunk.compressed = cursor.take(std::min<std::uint64_t>(head->compressed_size, cursor.left()));
  Unpacked unpacked = Unpacked::whole;
  if (head->compression.empty()) {
    chunk.records = chunk.compressed;
    if (chunk.records.size != head->uncompressed_size) unpacked = Unpacked::part;
  } else {
    unpacked = unpack(head->compression, chunk.compressed, head->uncompressed_size, chunk.unpacked);
    chunk.records = {chunk.unpacked.data(), chunk.unpacked.size()};
  }
  if (cut) return State::cut;
  if (unpacked != Unpacked::whole) return State::damaged;
  const std::uint32_t crc = head->uncompressed_crc;
  return crc == 0 || crc == crc32(chunk.records) ? State::whole : State::damaged;
}

}  // namespace

void load_chunk(ByteSource& source, const ChunkIndex& index, LoadedChunk& chunk) {
  chunk.state = LoadedChunk::State::damaged;
  chunk.head = {};
  chunk.compressed = chunk.records = {};
  const std::uint64_t skipped = index.is_plain ? 0 : record_head;
  const bool inside = index.length >= skipped && index.offset <= source.size() &&
                      index.length <= source.size() - index.offset;
  if (!inside) return;
  chunk.content.resize(static_cast<std::size_t>(index.length - skipped));
  if (!source.read(index.offset + skipped, chunk.content.data(), chunk.content.size())) return;
  if (index.is_plain) {
    chunk.records = {chunk.content.data(), chunk.content.size()};
    chunk.state = LoadedChunk::State::whole;
    return;
  }
  chunk.state = unpack_chunk(chunk);
  if (chunk.state == LoadedChunk::State::damaged) chunk.records = {};
}

}  // namespace tocsin::mcap
