// SPDX-License-Identifier: Apache-2.0
#include "bag/bag_reader.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "bag_stream.hpp"
#include "folder.hpp"
#include "foundation/error.hpp"
#include "foundation/read_file.hpp"
#include "totals.hpp"
#include "writer_key.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_metadata = 512 * 1024;  // [byte]

std::vector<std::string> files_of_folder(const fs::path& folder) {
  const fs::path metadata = folder / metadata_file;
  if (fs::exists(metadata)) {
    return files_in_metadata(read_file(metadata, longest_metadata), metadata);
  }
  std::vector<std::string> names = mcap_files_in(folder);
  if (names.empty()) {
    throw ConfigError(folder.string() + ": is no bag: it has neither " + metadata_file +
                      " nor an MCAP file");
  }
  return names;
}

/// All that the files have of a kind, apart from what cannot be read.
template <class One, class Index>
std::vector<One> all_of(const std::vector<BagReader::File>& files,
                        std::vector<Index> mcap::Summary::*indexes) {
  std::vector<One> all;
  for (const BagReader::File& file : files) {
    for (const Index& index : file.reader->summary().*indexes) {
      if (auto one = file.reader->read(index)) all.push_back(std::move(*one));
    }
  }
  return all;
}

/// 0: it is not told, or no number.
std::uint64_t writer_of(const mcap::Channel& channel) {
  const auto found = channel.metadata.find(writer_key);
  if (found == channel.metadata.end()) return 0;
  const std::string& text = found->second;
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole ? number : 0;
}

}  // namespace

BagReader::BagReader(const std::string& path) {
  if (fs::is_directory(path)) {
    for (const std::string& name : files_of_folder(path)) add_file(path, name);
  } else {
    add_file(fs::path(path).parent_path(), fs::path(path).filename());
  }
  set_totals(about_);
}

void BagReader::add_file(const std::string& folder, const std::string& name) {
  const fs::path path = fs::path(folder) / name;
  File file{name, std::make_unique<mcap::Reader>(path.string()), {}, {}};
  const mcap::Summary& summary = file.reader->summary();
  for (const auto& [id, channel] : summary.channels) {
    file.topic_of_channel.resize(id + std::size_t{1});
    file.writer_of_channel.resize(id + std::size_t{1});
    file.writer_of_channel[id] = writer_of(channel);
    const std::size_t number = topic_number(summary, channel);
    file.topic_of_channel[id] = number;
    const auto count = summary.statistics.channel_message_counts.find(id);
    if (count != summary.statistics.channel_message_counts.end()) {
      about_.topics[number].count += count->second;
    }
  }
  about_.files.push_back(described(name, summary.statistics));
  size_ += fs::file_size(path);
  files_.push_back(std::move(file));
}

/// Channels of one topic, for example one for each of its writers, are one here.
std::size_t BagReader::topic_number(const mcap::Summary& summary, const mcap::Channel& channel) {
  const auto schema = summary.schemas.find(channel.schema_id);
  Topic topic;
  topic.name = channel.topic;
  topic.serialization_format = channel.message_encoding;
  if (schema != summary.schemas.end()) {
    topic.type = schema->second.name;
    topic.definition_encoding = schema->second.encoding;
    topic.definition = schema->second.data;
  }
  const auto offered = channel.metadata.find("offered_qos_profiles");
  if (offered != channel.metadata.end()) topic.offered_qos = parse_offered_qos(offered->second);
  auto& topics = about_.topics;
  const auto same = std::find_if(topics.begin(), topics.end(), [&](const auto& one) {
    return one.topic.name == topic.name && one.topic.type == topic.type;
  });
  if (same == topics.end()) {
    topics.push_back({std::move(topic), 0});
    return topics.size() - 1;
  }
  if (same->topic.offered_qos.empty()) same->topic.offered_qos = topic.offered_qos;
  return static_cast<std::size_t>(same - topics.begin());
}

std::vector<std::pair<std::string, mcap::Damage>> BagReader::damaged() const {
  std::vector<std::pair<std::string, mcap::Damage>> all;
  for (const File& file : files_) {
    const mcap::Damage& damage = file.reader->damage();
    if (damage.no_summary || damage.chunks > 0 || damage.messages > 0) {
      all.emplace_back(file.name, damage);
    }
  }
  return all;
}

std::unique_ptr<BagStream> BagReader::messages(const Selection& selection) {
  return merged(files_, about_.topics, selection);
}

std::vector<mcap::Attachment> BagReader::attachments() {
  return all_of<mcap::Attachment>(files_, &mcap::Summary::attachments);
}

std::vector<mcap::Metadata> BagReader::metadata() {
  return all_of<mcap::Metadata>(files_, &mcap::Summary::metadata);
}

}  // namespace tocsin::bag
