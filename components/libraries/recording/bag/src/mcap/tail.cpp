// SPDX-License-Identifier: Apache-2.0
#include "mcap/tail.hpp"

#include <utility>

#include "chunk.hpp"
#include "scan.hpp"

namespace tocsin::mcap {

Tail::Step Tail::read(ByteSource& source, const OnMessage& on_message) {
  if (offset_ == 0) {
    (void)read_header(source, name_);
    if (source.size() < magic.size()) return Step::waits;
    offset_ = magic.size();
  }
  const auto head = read_head(source, offset_);
  // A power cut may leave zeros, which are no record.
  if (!head || head->opcode == Opcode{0}) return Step::waits;
  if (head->opcode == Opcode::data_end || head->opcode == Opcode::footer) return Step::ended;
  if (head->length > source.size() - offset_ - record_head) return Step::waits;
  const std::uint64_t length = record_head + head->length;
  if (head->opcode == Opcode::chunk) {
    visit_chunk(source, length, on_message);
  } else if (const auto content = content_at(source, offset_, head->opcode)) {
    visit(head->opcode, {content->data(), content->size()}, on_message);
  }
  offset_ += length;
  return Step::read;
}

void Tail::visit_chunk(ByteSource& source, std::uint64_t length, const OnMessage& on_message) {
  ChunkIndex index;
  index.offset = offset_;
  index.length = length;
  LoadedChunk chunk;
  load_chunk(source, index, chunk);
  if (chunk.state != LoadedChunk::State::whole) ++damaged_chunks_;
  for_each_record(chunk.records, [&](Opcode opcode, Span content, std::size_t) {
    visit(opcode, content, on_message);
  });
}

void Tail::visit(Opcode opcode, Span content, const OnMessage& on_message) {
  if (opcode == Opcode::schema) {
    if (auto schema = decode<Schema>(content)) schemas_.emplace(schema->id, std::move(*schema));
  } else if (opcode == Opcode::channel) {
    if (auto channel = decode<Channel>(content))
      channels_.emplace(channel->id, std::move(*channel));
  } else if (opcode == Opcode::message) {
    const auto message = decode<Message>(content);
    const auto channel = message ? channels_.find(message->channel_id) : channels_.end();
    if (channel != channels_.end()) on_message(channel->second, *message);
  }
}

}  // namespace tocsin::mcap
