// SPDX-License-Identifier: Apache-2.0
#include "bag_file.hpp"

#include "writer_key.hpp"

namespace tocsin::bag {
namespace {

mcap::WriterOptions options_of(mcap::Compression compression) {
  mcap::WriterOptions options;
  options.profile = "ros2";
  options.compression = compression;
  return options;
}

}  // namespace

BagWriter::File::File(const std::string& path, mcap::Compression compression)
    : sink_(path), writer_(sink_, options_of(compression)) {}

/// Each type once; topics of unknown types have a schema that tells the name.
std::uint16_t BagWriter::File::schema_of(const Topic& topic) {
  const auto [found, is_new] = schemas_.emplace(topic.type + "\n" + topic.definition, 0);
  if (is_new) {
    found->second =
        writer_.declare(mcap::Schema{0, topic.type, topic.definition_encoding, topic.definition})
            .value_or(0);
  }
  return found->second;
}

void BagWriter::File::add(const Topic& topic) {
  mcap::Channel channel;
  channel.schema_id = schema_of(topic);
  channel.topic = topic.name;
  channel.message_encoding = topic.serialization_format;
  channel.metadata["offered_qos_profiles"] = to_yaml(topic.offered_qos);
  channel.id = writer_.declare(channel).value_or(0);
  topics_.push_back(std::move(channel));
}

std::uint16_t BagWriter::File::channel_of(std::size_t topic, std::uint64_t writer) {
  const mcap::Channel& of_none = topics_.at(topic);
  if (writer == 0) return of_none.id;
  const auto [found, is_new] = of_writers_.try_emplace({topic, writer}, of_none.id);
  if (is_new) {
    mcap::Channel channel = of_none;
    channel.metadata[writer_key] = std::to_string(writer);
    found->second = writer_.declare(std::move(channel)).value_or(of_none.id);
  }
  return found->second;
}

mcap::Kept BagWriter::File::write(std::size_t topic, const Message& message) {
  if (start_ns_ == 0) start_ns_ = message.log_time_ns;
  return writer_.write(mcap::Message{channel_of(topic, message.writer), message.sequence,
                                     static_cast<std::uint64_t>(message.log_time_ns),
                                     static_cast<std::uint64_t>(message.publish_time_ns),
                                     message.data, message.size});
}

std::uint64_t BagWriter::File::count(std::size_t topic) const {
  const auto& counts = writer_.statistics().channel_message_counts;
  const auto of = [&counts](std::uint16_t channel) {
    const auto found = counts.find(channel);
    return found == counts.end() ? 0 : found->second;
  };
  std::uint64_t count = of(topics_.at(topic).id);
  for (const auto& [key, channel] : of_writers_) {
    const bool is_own = channel != topics_[topic].id;
    if (key.first == topic && is_own) count += of(channel);
  }
  return count;
}

}  // namespace tocsin::bag
