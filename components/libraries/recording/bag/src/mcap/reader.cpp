// SPDX-License-Identifier: Apache-2.0
#include "mcap/reader.hpp"

#include <utility>

#include "decode.hpp"
#include "message_stream.hpp"
#include "scan.hpp"
#include "summary_reading.hpp"

namespace tocsin::mcap {

Reader::Reader(const std::string& path) : Reader(std::make_unique<FileSource>(path), path) {}

Reader::Reader(std::unique_ptr<ByteSource> source, const std::string& name)
    : source_(std::move(source)) {
  Header header = read_header(*source_, name);
  if (!read_summary(*source_, summary_)) {
    summary_ = {};
    summarize(*source_, summary_, damage_);
    damage_.no_summary = true;
  }
  summary_.header = std::move(header);
}

std::unique_ptr<MessageStream> Reader::messages(Query query) {
  return make_message_stream(*source_, summary_, std::move(query), damage_);
}

std::optional<Attachment> Reader::read(const AttachmentIndex& index) {
  const auto content = content_at(*source_, index.offset, Opcode::attachment);
  if (!content) return std::nullopt;
  return decode<Attachment>({content->data(), content->size()});
}

std::optional<Metadata> Reader::read(const MetadataIndex& index) {
  const auto content = content_at(*source_, index.offset, Opcode::metadata);
  if (!content) return std::nullopt;
  return decode<Metadata>({content->data(), content->size()});
}

}  // namespace tocsin::mcap
