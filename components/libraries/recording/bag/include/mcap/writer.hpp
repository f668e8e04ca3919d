// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "mcap/byte_sink.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

struct WriterOptions {
  std::string profile;
  std::string library = "tocsin";
  /// A chunk that does not become smaller by it is kept as it is.
  Compression compression = Compression::none;
  /// [byte] A chunk is written when it has so many, or more by one message; the memory that a
  /// writer takes.
  std::size_t chunk_bytes = 786'432;
  bool crc = true;  ///< of chunks, attachments and the summary
};

/// A chunk as it stands in another file, and what is in it.
struct ReadyChunk {
  struct Entry {
    std::uint16_t channel_id;
    std::uint64_t log_time_ns;
    std::uint64_t offset;  ///< [byte] of the message's record in the decompressed chunk
  };
  std::string compression;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;
  Span compressed;
  std::vector<Entry> entries;
};

/// Writes one MCAP file. One thread; nothing throws.
///
/// The file is whole up to the last chunk at any time: schemas and channels stand before the chunk
/// that uses them, outside of it, and what a full disk refuses leaves nothing behind. Such a
/// chunk's messages are lost and counted; the next one is tried again.
class Writer {
 public:
  /// `sink` must outlive it.
  Writer(ByteSink& sink, WriterOptions options);
  /// Closes.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Makes a schema known under the next free id, which it returns. Empty when all are taken.
  [[nodiscard]] std::optional<std::uint16_t> declare(Schema schema);
  /// The same for a channel; also empty when its schema was not declared.
  [[nodiscard]] std::optional<std::uint16_t> declare(Channel channel);
  /// Makes a schema or channel of another file known under the id that it has there. Empty when
  /// that is taken, or the channel's schema was not declared.
  [[nodiscard]] std::optional<std::uint16_t> adopt(Schema schema);
  [[nodiscard]] std::optional<std::uint16_t> adopt(Channel channel);

  /// Takes a message of a channel that was declared. `Kept::nothing`: its chunk had to be written
  /// and there was no room.
  Kept write(const Message& message);
  /// Takes over a whole chunk of another file, whose channels were declared under their ids.
  Kept write(const ReadyChunk& chunk);
  Kept write(const Attachment& attachment);
  Kept write(const Metadata& metadata);
  /// Brings all messages to the file.
  Kept flush();
  /// Ends the file with its summary. After that nothing is taken.
  Kept close();

  /// [byte] That the file and the chunk which is still in memory have.
  [[nodiscard]] std::uint64_t size() const { return size_ + chunk_.size(); }
  /// Messages, by what was kept so far.
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  /// Messages that a full disk took.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  struct IndexEntry {
    std::uint64_t log_time_ns;
    std::uint64_t offset;
  };
  struct OpenChannel {
    Channel channel;
    std::vector<IndexEntry> entries;  ///< of the chunk in memory
  };
  void note(std::uint16_t channel, std::uint64_t log_time_ns, std::uint64_t offset);
  Kept put_chunk(const std::string& compression, std::uint64_t uncompressed_size, std::uint32_t crc,
                 Span compressed);
  Kept append(std::vector<Span> parts);
  void count_chunk(const ChunkIndex& index);
  void forget_chunk();
  [[nodiscard]] Bytes message_indexes(ChunkIndex& index) const;

  ByteSink& sink_;
  const WriterOptions options_;
  std::uint64_t size_ = 0;
  Bytes pending_;  ///< schemas and channels that no append has brought to the file yet
  Bytes chunk_;
  Bytes compressed_;
  std::uint64_t chunk_messages_ = 0;
  std::uint64_t chunk_start_ns_ = 0;
  std::uint64_t chunk_end_ns_ = 0;
  std::map<std::uint16_t, Schema> schemas_;
  std::vector<OpenChannel> channels_;
  std::unordered_map<std::uint16_t, std::size_t> channel_of_id_;
  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
  Statistics statistics_;
  std::uint64_t lost_ = 0;
  bool closed_ = false;
};

}  // namespace tocsin::mcap
