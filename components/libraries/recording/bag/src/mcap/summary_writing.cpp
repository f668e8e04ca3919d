// SPDX-License-Identifier: Apache-2.0
#include "summary_writing.hpp"

#include <functional>

#include "encode.hpp"

namespace tocsin::mcap {
namespace {

/// Records of one kind that follow each other.
struct Group {
  Opcode opcode;
  std::uint64_t start;
  std::uint64_t length;
};

class SummaryText {
 public:
  explicit SummaryText(std::uint64_t offset) : offset_(offset) {}

  Bytes bytes;

  template <class Records, class Put>
  void group(Opcode opcode, const Records& records, const Put& put_one) {
    const std::size_t begin = bytes.size();
    for (const auto& record : records) put_one(record);
    if (bytes.size() > begin) groups_.push_back({opcode, offset_ + begin, bytes.size() - begin});
  }
  void offsets() {
    for (const Group& group : groups_) {
      const std::size_t begin = begin_record(bytes, Opcode::summary_offset);
      put_number(bytes, static_cast<std::uint8_t>(group.opcode), 1);
      put_number(bytes, group.start, 8);
      put_number(bytes, group.length, 8);
      end_record(bytes, begin);
    }
  }

 private:
  std::uint64_t offset_;
  std::vector<Group> groups_;
};

void put_data_end(Bytes& to) {
  const std::size_t begin = begin_record(to, Opcode::data_end);
  put_number(to, 0, 4);  // no checksum of the whole data: each chunk has its own
  end_record(to, begin);
}

}  // namespace

Bytes end_of_file(const SummaryParts& parts, std::uint64_t offset, bool crc) {
  Bytes end;
  put_data_end(end);
  const std::uint64_t start = offset + end.size();
  SummaryText text(start);
  const auto put_one = [&](const auto& record) { put(text.bytes, record); };
  text.group(Opcode::schema, parts.schemas, [&](const auto& one) { put_one(one.second); });
  text.group(Opcode::channel, parts.channels, [&](const Channel* one) { put_one(*one); });
  text.group(Opcode::statistics, std::vector{std::cref(parts.statistics)},
             [&](const Statistics& one) { put_one(one); });
  text.group(Opcode::chunk_index, parts.chunks, put_one);
  text.group(Opcode::attachment_index, parts.attachments, put_one);
  text.group(Opcode::metadata_index, parts.metadata, put_one);
  const std::uint64_t offsets_start = start + text.bytes.size();
  text.offsets();
  const std::size_t footer = begin_record(text.bytes, Opcode::footer);
  put_number(text.bytes, start, 8);
  put_number(text.bytes, offsets_start, 8);
  put_number(text.bytes, 0, 4);
  end_record(text.bytes, footer);
  const std::size_t covered = text.bytes.size() - 4;
  const std::uint32_t sum = crc ? crc32({text.bytes.data(), covered}) : 0;
  text.bytes.resize(covered);
  put_number(text.bytes, sum, 4);
  end.insert(end.end(), text.bytes.begin(), text.bytes.end());
  end.insert(end.end(), magic.begin(), magic.end());
  return end;
}

}  // namespace tocsin::mcap
