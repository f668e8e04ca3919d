// SPDX-License-Identifier: Apache-2.0
#include "mcap/writer.hpp"

#include <algorithm>
#include <utility>

#include "compression.hpp"
#include "encode.hpp"
#include "summary_writing.hpp"

namespace tocsin::mcap {
namespace {

constexpr std::size_t most_ids = 65'535;

/// The next free id of `map`, whose keys are ids; 0 when all are taken.
template <class Map>
std::uint16_t free_id(const Map& map) {
  auto id = static_cast<std::uint16_t>(map.size() + 1);
  for (std::size_t tried = 0; tried < most_ids; ++tried, ++id) {
    if (id != 0 && map.count(id) == 0) return id;
  }
  return 0;
}

Span span_of(const Bytes& bytes) { return {bytes.data(), bytes.size()}; }

}  // namespace

Writer::Writer(ByteSink& sink, WriterOptions options) : sink_(sink), options_(std::move(options)) {
  pending_.assign(magic.begin(), magic.end());
  put(pending_, Header{options_.profile, options_.library});
}

Writer::~Writer() { (void)close(); }

std::optional<std::uint16_t> Writer::declare(Schema schema) {
  schema.id = free_id(schemas_);
  return adopt(std::move(schema));
}

std::optional<std::uint16_t> Writer::declare(Channel channel) {
  channel.id = free_id(channel_of_id_);
  if (channel.id == 0) return std::nullopt;
  return adopt(std::move(channel));
}

std::optional<std::uint16_t> Writer::adopt(Schema schema) {
  const std::uint16_t id = schema.id;
  if (closed_ || id == 0 || schemas_.count(id) != 0) return std::nullopt;
  put(pending_, schema);
  schemas_.emplace(id, std::move(schema));
  ++statistics_.schema_count;
  return id;
}

std::optional<std::uint16_t> Writer::adopt(Channel channel) {
  if (closed_ || (channel.schema_id != 0 && schemas_.count(channel.schema_id) == 0)) {
    return std::nullopt;
  }
  const std::uint16_t id = channel.id;
  if (!channel_of_id_.emplace(id, channels_.size()).second) return std::nullopt;
  put(pending_, channel);
  channels_.push_back({std::move(channel), {}});
  ++statistics_.channel_count;
  return id;
}

void Writer::note(std::uint16_t channel, std::uint64_t log_time_ns, std::uint64_t offset) {
  channels_[channel_of_id_.at(channel)].entries.push_back({log_time_ns, offset});
  chunk_start_ns_ = chunk_messages_ == 0 ? log_time_ns : std::min(chunk_start_ns_, log_time_ns);
  chunk_end_ns_ = chunk_messages_ == 0 ? log_time_ns : std::max(chunk_end_ns_, log_time_ns);
  ++chunk_messages_;
}

Kept Writer::write(const Message& message) {
  if (closed_ || channel_of_id_.count(message.channel_id) == 0) return Kept::nothing;
  note(message.channel_id, message.log_time_ns, chunk_.size());
  put(chunk_, message);
  return chunk_.size() >= options_.chunk_bytes ? flush() : Kept::all;
}

Kept Writer::write(const ReadyChunk& chunk) {
  if (closed_ || flush() == Kept::nothing) return Kept::nothing;
  const auto known = [&](const auto& entry) { return channel_of_id_.count(entry.channel_id) != 0; };
  if (!std::all_of(chunk.entries.begin(), chunk.entries.end(), known)) return Kept::nothing;
  for (const auto& entry : chunk.entries) note(entry.channel_id, entry.log_time_ns, entry.offset);
  return put_chunk(chunk.compression, chunk.uncompressed_size, chunk.uncompressed_crc,
                   chunk.compressed);
}

Kept Writer::flush() {
  if (closed_) return Kept::nothing;
  if (chunk_messages_ == 0) return pending_.empty() ? Kept::all : append({});
  const Span whole = span_of(chunk_);
  const std::uint32_t crc = options_.crc ? crc32(whole) : 0;
  const bool smaller = compress(options_.compression, whole, compressed_);
  return put_chunk(smaller ? name_in_file(options_.compression) : "", whole.size, crc,
                   smaller ? span_of(compressed_) : whole);
}

Kept Writer::put_chunk(const std::string& compression, std::uint64_t uncompressed_size,
                       std::uint32_t crc, Span compressed) {
  Bytes head;
  const std::size_t begin = begin_record(head, Opcode::chunk);
  put_number(head, chunk_start_ns_, 8);
  put_number(head, chunk_end_ns_, 8);
  put_number(head, uncompressed_size, 8);
  put_number(head, crc, 4);
  put_text(head, compression);
  put_number(head, compressed.size, 8);
  end_record(head, begin, compressed.size);

  ChunkIndex index{chunk_start_ns_,
                   chunk_end_ns_,
                   size_ + pending_.size(),
                   head.size() + compressed.size,
                   {},
                   0,
                   compression,
                   compressed.size,
                   uncompressed_size};
  const Bytes indexes = message_indexes(index);
  const Kept kept = append({span_of(head), compressed, span_of(indexes)});
  if (kept == Kept::all) count_chunk(index);
  if (kept == Kept::nothing) lost_ += chunk_messages_;
  forget_chunk();
  return kept;
}

/// The records behind the chunk of `index`, which is told where they stand.
Bytes Writer::message_indexes(ChunkIndex& index) const {
  Bytes indexes;
  for (const OpenChannel& channel : channels_) {
    if (channel.entries.empty()) continue;
    index.message_indexes.emplace_back(channel.channel.id,
                                       index.offset + index.length + indexes.size());
    const std::size_t at = begin_record(indexes, Opcode::message_index);
    put_number(indexes, channel.channel.id, 2);
    put_number(indexes, sizeof(IndexEntry) * channel.entries.size(), 4);
    for (const IndexEntry& entry : channel.entries) {
      put_number(indexes, entry.log_time_ns, 8);
      put_number(indexes, entry.offset, 8);
    }
    end_record(indexes, at);
  }
  index.message_index_length = indexes.size();
  return indexes;
}

void Writer::count_chunk(const ChunkIndex& index) {
  Statistics& all = statistics_;
  all.start_ns = all.message_count == 0 ? index.start_ns : std::min(all.start_ns, index.start_ns);
  all.end_ns = std::max(all.end_ns, index.end_ns);
  all.message_count += chunk_messages_;
  ++all.chunk_count;
  for (const OpenChannel& channel : channels_) {
    if (channel.entries.empty()) continue;
    all.channel_message_counts[channel.channel.id] += channel.entries.size();
  }
  chunk_indexes_.push_back(index);
}

void Writer::forget_chunk() {
  for (OpenChannel& channel : channels_) channel.entries.clear();
  chunk_.clear();
  chunk_messages_ = 0;
}

Kept Writer::write(const Attachment& attachment) {
  if (closed_) return Kept::nothing;
  Bytes record;
  put(record, attachment, options_.crc);
  const std::uint64_t offset = size_ + pending_.size();
  if (append({span_of(record)}) == Kept::nothing) return Kept::nothing;
  attachment_indexes_.push_back({offset, record.size(), attachment.log_time_ns,
                                 attachment.create_time_ns, attachment.data.size(), attachment.name,
                                 attachment.media_type});
  ++statistics_.attachment_count;
  return Kept::all;
}

Kept Writer::write(const Metadata& metadata) {
  if (closed_) return Kept::nothing;
  Bytes record;
  put(record, metadata);
  const std::uint64_t offset = size_ + pending_.size();
  if (append({span_of(record)}) == Kept::nothing) return Kept::nothing;
  metadata_indexes_.push_back({offset, record.size(), metadata.name});
  ++statistics_.metadata_count;
  return Kept::all;
}

Kept Writer::append(std::vector<Span> parts) {
  parts.insert(parts.begin(), span_of(pending_));
  if (sink_.append(parts) == Kept::nothing) return Kept::nothing;
  for (const Span& part : parts) size_ += part.size;
  pending_.clear();
  return Kept::all;
}

Kept Writer::close() {
  if (closed_) return Kept::all;
  const Kept flushed = flush();
  SummaryParts parts{schemas_,         {}, statistics_, chunk_indexes_, attachment_indexes_,
                     metadata_indexes_};
  for (const OpenChannel& channel : channels_) parts.channels.push_back(&channel.channel);
  const Bytes end = end_of_file(parts, size_ + pending_.size(), options_.crc);
  const Kept ended = append({span_of(end)});
  closed_ = true;
  return flushed == Kept::all ? ended : flushed;
}

}  // namespace tocsin::mcap
