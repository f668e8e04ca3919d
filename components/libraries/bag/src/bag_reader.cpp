// SPDX-License-Identifier: Apache-2.0
#include "bag/bag_reader.hpp"

#include <algorithm>
#include <filesystem>

#include "bag_stream.hpp"
#include "foundation/error.hpp"
#include "foundation/read_file.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_metadata = 512 * 1024;  // [byte]

std::vector<std::string> files_of_folder(const fs::path& folder) {
  const fs::path metadata = folder / metadata_file;
  if (fs::exists(metadata)) {
    return files_in_metadata(read_file(metadata, longest_metadata), metadata);
  }
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".mcap") names.push_back(file.path().filename());
  }
  std::sort(names.begin(), names.end());
  if (names.empty()) {
    throw ConfigError(folder.string() + ": is no bag: it has neither " + metadata_file +
                      " nor an MCAP file");
  }
  return names;
}

}  // namespace

std::int64_t time_of(std::uint64_t ns) {
  constexpr std::uint64_t latest = 9'000'000'000'000'000'000U;  // the year 2255
  return static_cast<std::int64_t>(std::min(ns, latest));
}

BagReader::BagReader(const std::string& path) {
  if (fs::is_directory(path)) {
    for (const std::string& name : files_of_folder(path)) add_file(path, name);
  } else {
    add_file(fs::path(path).parent_path(), fs::path(path).filename());
  }
  for (const Metadata::File& file : about_.files) {
    if (file.count == 0) continue;
    const std::int64_t end_ns =
        std::max(about_.start_ns + about_.duration_ns, file.start_ns + file.duration_ns);
    about_.start_ns = about_.count == 0 ? file.start_ns : std::min(about_.start_ns, file.start_ns);
    about_.duration_ns = end_ns - about_.start_ns;
    about_.count += file.count;
  }
}

void BagReader::add_file(const std::string& folder, const std::string& name) {
  const fs::path path = fs::path(folder) / name;
  File file{name, std::make_unique<mcap::Reader>(path.string()), {}};
  const mcap::Summary& summary = file.reader->summary();
  for (const auto& [id, channel] : summary.channels) {
    file.topic_of_channel.resize(id + std::size_t{1});
    const std::size_t number = topic_number(summary, channel);
    file.topic_of_channel[id] = number;
    const auto count = summary.statistics.channel_message_counts.find(id);
    if (count != summary.statistics.channel_message_counts.end()) {
      about_.topics[number].count += count->second;
    }
  }
  const std::int64_t start_ns = time_of(summary.statistics.start_ns);
  const std::int64_t end_ns = time_of(summary.statistics.end_ns);
  about_.files.push_back({name, start_ns, end_ns - start_ns, summary.statistics.message_count});
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
  std::vector<mcap::Attachment> all;
  for (File& file : files_) {
    for (const auto& index : file.reader->summary().attachments) {
      if (auto one = file.reader->read(index)) all.push_back(std::move(*one));
    }
  }
  return all;
}

std::vector<mcap::Metadata> BagReader::metadata() {
  std::vector<mcap::Metadata> all;
  for (File& file : files_) {
    for (const auto& index : file.reader->summary().metadata) {
      if (auto one = file.reader->read(index)) all.push_back(std::move(*one));
    }
  }
  return all;
}

}  // namespace tocsin::bag
