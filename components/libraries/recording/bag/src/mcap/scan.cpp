// SPDX-License-Identifier: Apache-2.0
#include "scan.hpp"

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::mcap {
namespace {

class Walk {
 public:
  Walk(ByteSource& source, ScanVisitor& visitor) : source_(source), visitor_(visitor) {}

  Damage run() {
    Place place{magic.size(), 0};
    damage_.no_summary = true;
    if (source_.size() < place.offset) damage_.cut_at = 0;
    while (place.offset < source_.size()) {
      const auto found = find_record(place);
      // A power cut may leave zeros, which are no record.
      if (!found || found->opcode == Opcode{0} || (found->cut && found->opcode != Opcode::chunk)) {
        damage_.cut_at = place.offset;
        return damage_;
      }
      if (found->opcode == Opcode::data_end || found->opcode == Opcode::footer) {
        damage_.no_summary = false;
        return damage_;
      }
      visit(found->opcode, place);
      if (found->cut) damage_.cut_at = place.offset;
      place.offset += place.length;
    }
    return damage_;
  }

 private:
  struct FoundRecord {
    Opcode opcode;
    bool cut;  ///< the file ends in it
  };
  /// What begins at `place`, whose length it tells: to the end of the record or of the file.
  std::optional<FoundRecord> find_record(Place& place) {
    const auto head = read_head(source_, place.offset);
    if (!head) return std::nullopt;
    const std::uint64_t left = source_.size() - place.offset;
    const bool cut = head->length > left - record_head;
    place.length = cut ? left : record_head + head->length;
    return FoundRecord{head->opcode, cut};
  }

  void visit(Opcode opcode, const Place& place) {
    if (opcode == Opcode::chunk) {
      visit_chunk(place);
      return;
    }
    const bool known = opcode == Opcode::schema || opcode == Opcode::channel ||
                       opcode == Opcode::message || opcode == Opcode::attachment ||
                       opcode == Opcode::metadata;
    if (!known) return;
    content_.resize(static_cast<std::size_t>(place.length - record_head));
    if (!source_.read(place.offset + record_head, content_.data(), content_.size())) return;
    visit_content(opcode, place);
  }

  void visit_content(Opcode opcode, const Place& place) {
    const Span content{content_.data(), content_.size()};
    if (opcode == Opcode::message) {
      if (const auto message = decode<Message>(content)) visitor_.on_message(place, *message);
    } else if (opcode == Opcode::attachment) {
      if (auto one = decode<Attachment>(content)) visitor_.on_attachment(place, std::move(*one));
    } else if (opcode == Opcode::metadata) {
      if (auto one = decode<Metadata>(content)) visitor_.on_metadata(place, std::move(*one));
    } else {
      show_declaration(visitor_, opcode, content);
    }
  }

  void visit_chunk(const Place& place) {
    ChunkIndex index;
    index.offset = place.offset;
    index.length = place.length;
    load_chunk(source_, index, chunk_);
    if (chunk_.state == LoadedChunk::State::damaged) {
      ++damage_.chunks;
    } else {
      visitor_.on_chunk(place, chunk_);
    }
  }

  ByteSource& source_;
  ScanVisitor& visitor_;
  Damage damage_;
  Bytes content_;
  LoadedChunk chunk_;
};

/// Makes the index that the file lacks.
class Summarizer final : public ScanVisitor {
 public:
  Summarizer(Summary& summary, Damage& damage) : summary_(summary), damage_(damage) {}

  void on_schema(Schema&& schema) override { summary_.schemas.emplace(schema.id, schema); }
  void on_channel(Channel&& channel) override { summary_.channels.emplace(channel.id, channel); }
  void on_message(const Place& place, const Message& message) override {
    constexpr std::uint64_t longest_run = 1'048'576;  // [byte]
    auto& chunks = summary_.chunks;
    const bool follows = !chunks.empty() && chunks.back().is_plain &&
                         chunks.back().offset + chunks.back().length == place.offset &&
                         chunks.back().length < longest_run;
    if (!follows) {
      chunks.emplace_back();
      chunks.back().offset = place.offset;
      chunks.back().is_plain = true;
      counted_ = 0;
    }
    chunks.back().length = place.offset + place.length - chunks.back().offset;
    count(message);
  }
  void on_chunk(const Place& place, const LoadedChunk& chunk) override {
    ChunkIndex index;
    index.offset = place.offset;
    index.length = place.length;
    index.compression = chunk.head.compression;
    index.compressed_size = chunk.compressed.size;
    index.uncompressed_size = chunk.records.size;
    summary_.chunks.push_back(std::move(index));
    counted_ = 0;
    for_each_record(chunk.records, [this](Opcode opcode, Span content, std::size_t) {
      if (opcode == Opcode::message) {
        if (const auto message = decode<Message>(content)) count(*message);
      } else {
        show_declaration(*this, opcode, content);
      }
    });
    ++summary_.statistics.chunk_count;
  }
  void on_attachment(const Place& place, Attachment&& one) override {
    summary_.attachments.push_back({place.offset, place.length, one.log_time_ns, one.create_time_ns,
                                    one.data.size(), one.name, one.media_type});
  }
  void on_metadata(const Place& place, Metadata&& one) override {
    summary_.metadata.push_back({place.offset, place.length, one.name});
  }

  void finish() {
    Statistics& all = summary_.statistics;
    all.schema_count = static_cast<std::uint16_t>(summary_.schemas.size());
    all.channel_count = static_cast<std::uint32_t>(summary_.channels.size());
    all.attachment_count = static_cast<std::uint32_t>(summary_.attachments.size());
    all.metadata_count = static_cast<std::uint32_t>(summary_.metadata.size());
  }

 private:
  void count(const Message& message) {
    if (summary_.channels.count(message.channel_id) == 0) {
      ++damage_.messages;
      return;
    }
    const std::uint64_t time_ns = message.log_time_ns;
    ChunkIndex& chunk = summary_.chunks.back();
    chunk.start_ns = counted_ == 0 ? time_ns : std::min(chunk.start_ns, time_ns);
    chunk.end_ns = std::max(chunk.end_ns, time_ns);
    ++counted_;
    Statistics& all = summary_.statistics;
    all.start_ns = all.message_count == 0 ? time_ns : std::min(all.start_ns, time_ns);
    all.end_ns = std::max(all.end_ns, time_ns);
    ++all.message_count;
    ++all.channel_message_counts[message.channel_id];
  }

  Summary& summary_;
  Damage& damage_;
  std::uint64_t counted_ = 0;  ///< messages of the last chunk
};

}  // namespace

void show_declaration(ScanVisitor& visitor, Opcode opcode, Span content) {
  if (opcode == Opcode::schema) {
    if (auto schema = decode<Schema>(content)) visitor.on_schema(std::move(*schema));
  } else if (opcode == Opcode::channel) {
    if (auto channel = decode<Channel>(content)) visitor.on_channel(std::move(*channel));
  }
}

std::optional<RecordHead> read_head(ByteSource& source, std::uint64_t offset) {
  std::array<std::uint8_t, record_head> head{};
  if (!source.read(offset, head.data(), head.size())) return std::nullopt;
  Cursor cursor({head.data(), head.size()});
  const auto opcode = static_cast<Opcode>(cursor.number(1));
  return RecordHead{opcode, cursor.number(8)};
}

std::optional<Bytes> content_at(ByteSource& source, std::uint64_t offset, Opcode wanted) {
  const auto head = read_head(source, offset);
  if (!head || head->opcode != wanted) return std::nullopt;
  const std::uint64_t at = offset + record_head;
  if (head->length > source.size() - at) return std::nullopt;
  Bytes content(static_cast<std::size_t>(head->length));
  if (!source.read(at, content.data(), content.size())) return std::nullopt;
  return content;
}

Header read_header(ByteSource& source, const std::string& name) {
  std::array<std::uint8_t, magic.size()> begin{};
  const auto there = static_cast<std::size_t>(std::min<std::uint64_t>(magic.size(), source.size()));
  if (!source.read(0, begin.data(), there) ||
      !std::equal(begin.begin(), begin.begin() + there, magic.begin())) {
    throw ConfigError(name + ": is no MCAP file");
  }
  const auto content = content_at(source, magic.size(), Opcode::header);
  if (!content) return {};
  return decode<Header>({content->data(), content->size()}).value_or(Header{});
}

Damage scan(ByteSource& source, ScanVisitor& visitor) { return Walk(source, visitor).run(); }

void summarize(ByteSource& source, Summary& summary, Damage& damage) {
  Summarizer summarizer(summary, damage);
  const std::uint64_t without_channel = damage.messages;
  Damage found = scan(source, summarizer);
  found.messages += damage.messages - without_channel;
  damage = found;
  summarizer.finish();
}

}  // namespace tocsin::mcap
