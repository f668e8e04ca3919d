// SPDX-License-Identifier: Apache-2.0
// A walk over a file from its beginning to the end of its data.
#pragma once

#include <optional>
#include <string>

#include "chunk.hpp"
#include "mcap/byte_source.hpp"
#include "mcap/format.hpp"
#include "mcap/reader.hpp"

namespace tocsin::mcap {

/// Where a record stands.
struct Place {
  std::uint64_t offset;
  std::uint64_t length;  ///< [byte] opcode and length included
};

/// Is shown what a walk comes by, in the order of the file.
class ScanVisitor {
 public:
  virtual ~ScanVisitor() = default;
  virtual void on_schema(Schema&& schema) = 0;
  virtual void on_channel(Channel&& channel) = 0;
  /// A message outside of chunks.
  virtual void on_message(const Place& place, const Message& message) = 0;
  /// Not one that is damaged.
  virtual void on_chunk(const Place& place, const LoadedChunk& chunk) = 0;
  virtual void on_attachment(const Place& place, Attachment&& attachment) = 0;
  virtual void on_metadata(const Place& place, Metadata&& metadata) = 0;
};

/// Shows a schema or a channel; nothing for records of another kind.
void show_declaration(ScanVisitor& visitor, Opcode opcode, Span content);

/// What stands in front of a record's content.
struct RecordHead {
  Opcode opcode;
  std::uint64_t length;  ///< [byte] of the content, as the file claims
};

/// Empty when the file ends before or within it.
[[nodiscard]] std::optional<RecordHead> read_head(ByteSource& source, std::uint64_t offset);

/// The content of the record at `offset`; empty when it is not there or of another kind.
[[nodiscard]] std::optional<Bytes> content_at(ByteSource& source, std::uint64_t offset,
                                              Opcode wanted);

/// Throws ConfigError, with `name`, when the file does not begin as MCAP does. Of a file that was
/// cut within its header the header is empty.
[[nodiscard]] Header read_header(ByteSource& source, const std::string& name);

/// Returns what the file lacks, apart from messages without a channel.
Damage scan(ByteSource& source, ScanVisitor& visitor);

/// Makes a summary by a walk over the whole file.
void summarize(ByteSource& source, Summary& summary, Damage& damage);

}  // namespace tocsin::mcap
