// SPDX-License-Identifier: Apache-2.0
#include "summary_reading.hpp"

#include <algorithm>
#include <utility>

#include "chunk.hpp"
#include "decode.hpp"
#include "encode.hpp"

namespace tocsin::mcap {
namespace {

struct FoundFooter {
  Footer footer;
  std::uint64_t offset;
};

std::optional<FoundFooter> find_footer(ByteSource& source) {
  Bytes end(footer_size);
  if (source.size() < magic.size() + footer_size) return std::nullopt;
  const std::uint64_t offset = source.size() - footer_size;
  if (!source.read(offset, end.data(), end.size())) return std::nullopt;
  Cursor cursor({end.data(), end.size()});
  if (static_cast<Opcode>(cursor.number(1)) != Opcode::footer || cursor.number(8) != 20) {
    return std::nullopt;
  }
  const auto footer = decode<Footer>(cursor.take(20));
  const bool closed = std::equal(magic.begin(), magic.end(), end.end() - magic.size());
  if (!footer || !closed) return std::nullopt;
  if (footer->summary_start < magic.size() || footer->summary_start >= offset) return std::nullopt;
  return FoundFooter{*footer, offset};
}

/// Takes over one record of the summary; false when it says nothing sensible.
class SummaryParser {
 public:
  explicit SummaryParser(Summary& summary) : summary_(summary) {}

  void take(Opcode opcode, Span content) {
    if (opcode == Opcode::schema) {
      keep(decode<Schema>(content), [&](Schema&& one) { summary_.schemas.emplace(one.id, one); });
    } else if (opcode == Opcode::channel) {
      keep(decode<Channel>(content),
           [&](Channel&& one) { summary_.channels.emplace(one.id, one); });
    } else if (opcode == Opcode::chunk_index) {
      keep(decode<ChunkIndex>(content),
           [&](ChunkIndex&& one) { summary_.chunks.push_back(std::move(one)); });
    } else if (opcode == Opcode::attachment_index) {
      keep(decode<AttachmentIndex>(content),
           [&](AttachmentIndex&& one) { summary_.attachments.push_back(std::move(one)); });
    } else if (opcode == Opcode::metadata_index) {
      keep(decode<MetadataIndex>(content),
           [&](MetadataIndex&& one) { summary_.metadata.push_back(std::move(one)); });
    } else if (opcode == Opcode::statistics) {
      keep(decode<Statistics>(content), [&](Statistics&& one) {
        summary_.statistics = std::move(one);
        counted_ = true;
      });
    }
  }

  /// Whether it can be used: everything has been understood, and every message is in a chunk that
  /// is known with a channel that is known.
  [[nodiscard]] bool complete() const {
    const Statistics& all = summary_.statistics;
    return good_ && counted_ && all.chunk_count == summary_.chunks.size() &&
           (all.message_count == 0 || all.chunk_count > 0) &&
           all.channel_count == summary_.channels.size();
  }

 private:
  template <class T, class Take>
  void keep(std::optional<T>&& decoded, const Take& take) {
    if (decoded) {
      take(std::move(*decoded));
    } else {
      good_ = false;
    }
  }

  Summary& summary_;
  bool good_ = true;
  bool counted_ = false;
};

bool is_inside(const ChunkIndex& chunk, std::uint64_t end) {
  return chunk.offset >= magic.size() && chunk.length >= record_head && chunk.offset <= end &&
         chunk.length <= end - chunk.offset;
}

}  // namespace

bool read_summary(ByteSource& source, Summary& summary) {
  const auto found = find_footer(source);
  if (!found) return false;
  const Footer& footer = found->footer;
  const std::uint64_t start = footer.summary_start;
  constexpr std::uint64_t crc_field = 4;
  Bytes bytes(static_cast<std::size_t>(source.size() - magic.size() - crc_field - start));
  if (!source.read(start, bytes.data(), bytes.size())) return false;
  if (footer.summary_crc != 0 && footer.summary_crc != crc32({bytes.data(), bytes.size()})) {
    return false;
  }
  SummaryParser parser(summary);
  for_each_record({bytes.data(), static_cast<std::size_t>(found->offset - start)},
                  [&](Opcode opcode, Span content, std::size_t) { parser.take(opcode, content); });
  auto& chunks = summary.chunks;
  std::sort(chunks.begin(), chunks.end(),
            [](const ChunkIndex& a, const ChunkIndex& b) { return a.offset < b.offset; });
  return parser.complete() && std::all_of(chunks.begin(), chunks.end(), [&](const auto& chunk) {
           return is_inside(chunk, start);
         });
}

}  // namespace tocsin::mcap
