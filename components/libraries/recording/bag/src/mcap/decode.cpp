// SPDX-License-Identifier: Apache-2.0
#include "decode.hpp"

#include "encode.hpp"

namespace tocsin::mcap {
namespace {

template <class Number, class = std::enable_if_t<std::is_unsigned_v<Number>>>
void take_field(Cursor& c, Number& value) {
  value = static_cast<Number>(c.number(sizeof value));
}

void take_field(Cursor& c, std::string& text) { text = c.text(); }

/// Pairs behind their length in bytes.
template <class Pairs, typename Pairs::const_iterator* = nullptr>
void take_field(Cursor& c, Pairs& values) {
  Cursor inner(c.take(c.number(4)));
  while (inner.good() && inner.left() > 0) {
    std::pair<std::remove_const_t<typename Pairs::value_type::first_type>,
              typename Pairs::value_type::second_type>
        pair;
    take_field(inner, pair.first);
    take_field(inner, pair.second);
    values.insert(values.end(), std::move(pair));
  }
  if (!inner.good()) c.fail();
}

/// Empty when a field was not there.
template <class Record>
std::optional<Record> take(Cursor& c) {
  Record record;
  std::apply([&c](auto&... field) { (take_field(c, field), ...); }, fields_of(record));
  if (!c.good()) return std::nullopt;
  return record;
}

}  // namespace

template <class Record>
std::optional<Record> decode(Span content) {
  Cursor c(content);
  return take<Record>(c);
}
template std::optional<Header> decode(Span);
template std::optional<Channel> decode(Span);
template std::optional<Metadata> decode(Span);
template std::optional<ChunkIndex> decode(Span);
template std::optional<AttachmentIndex> decode(Span);
template std::optional<MetadataIndex> decode(Span);
template std::optional<Statistics> decode(Span);
template std::optional<Footer> decode(Span);

template <>
std::optional<Schema> decode(Span content) {
  Cursor c(content);
  auto schema = take<Schema>(c);
  return schema && schema->id != 0 ? schema : std::nullopt;
}

template <>
std::optional<Message> decode(Span content) {
  Cursor c(content);
  auto message = take<Message>(c);
  if (!message) return std::nullopt;
  const Span data = c.take(c.left());
  message->data = data.data;
  message->size = data.size;
  return message;
}

template <>
std::optional<Attachment> decode(Span content) {
  Cursor c(content);
  auto attachment = take<Attachment>(c);
  const Span data = c.take(c.number(8));
  const std::size_t covered = c.at();
  const std::uint64_t crc = c.number(4);
  if (!c.good() || (crc != 0 && crc != crc32({content.data, covered}))) return std::nullopt;
  attachment->data.assign(reinterpret_cast<const char*>(data.data), data.size);
  return attachment;
}

std::optional<ChunkHead> decode_chunk_head(Cursor& cursor) { return take<ChunkHead>(cursor); }

}  // namespace tocsin::mcap
