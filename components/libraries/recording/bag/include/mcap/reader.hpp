// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mcap/byte_source.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

/// All that is known of a file without its messages.
struct Summary {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  std::vector<ChunkIndex> chunks;  ///< in the order of the file
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
};

/// What a file lacks.
struct Damage {
  bool no_summary = false;              ///< it was not closed, or its summary is damaged
  std::optional<std::uint64_t> cut_at;  ///< [byte] where a record begins that has no end
  std::uint64_t chunks = 0;             ///< whose checksum is wrong or that cannot be unpacked
  std::uint64_t messages = 0;           ///< of channels that nobody declared
};

enum class Order {
  log_time,  ///< messages of one time in the order of the file
  file
};

/// Which messages are wanted.
struct Query {
  std::uint64_t from_ns = 0;                                        ///< log time, included
  std::uint64_t to_ns = std::numeric_limits<std::uint64_t>::max();  ///< log time, included
  std::function<bool(const Channel&)> wanted;                       ///< empty: all
  Order order = Order::log_time;
};

/// Gives messages one by one.
class MessageStream {
 public:
  virtual ~MessageStream() = default;
  /// Empty: there are no more. The bytes are valid until the next call.
  [[nodiscard]] virtual std::optional<Message> next() = 0;
};

/// Reads one MCAP file, made by whomever, whole or cut. One thread.
///
/// Opens by the summary alone, in the time that its index takes; without one, or with a damaged
/// one, it walks over the whole file. No memory is taken for what a file only claims: a length is
/// compared with what is left of the file, and what is unpacked grows as it comes.
class Reader {
 public:
  /// Throws ConfigError, with `name`, when it is no MCAP file.
  Reader(std::unique_ptr<ByteSource> source, const std::string& name);
  /// Opens the file `path`.
  explicit Reader(const std::string& path);

  [[nodiscard]] const Summary& summary() const { return summary_; }
  [[nodiscard]] const Damage& damage() const { return damage_; }
  /// The reader must outlive the stream; only one stream is read at a time. In order of log time it
  /// holds the chunks in memory that overlap in time.
  [[nodiscard]] std::unique_ptr<MessageStream> messages(Query query = {});
  /// Empty when it cannot be read, or its checksum is wrong.
  [[nodiscard]] std::optional<Attachment> read(const AttachmentIndex& index);
  [[nodiscard]] std::optional<Metadata> read(const MetadataIndex& index);

 private:
  std::unique_ptr<ByteSource> source_;
  Summary summary_;
  Damage damage_;
};

}  // namespace tocsin::mcap
