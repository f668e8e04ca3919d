// SPDX-License-Identifier: Apache-2.0
#include "bag_file.hpp"

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
  channels_.push_back(writer_.declare(std::move(channel)).value_or(0));
}

mcap::Kept BagWriter::File::write(std::size_t topic, const Message& message) {
  if (start_ns_ == 0) start_ns_ = message.log_time_ns;
  return writer_.write(mcap::Message{
      channels_.at(topic), message.sequence, static_cast<std::uint64_t>(message.log_time_ns),
      static_cast<std::uint64_t>(message.publish_time_ns), message.data, message.size});
}

std::uint64_t BagWriter::File::count(std::size_t topic) const {
  const auto& counts = writer_.statistics().channel_message_counts;
  const auto found = counts.find(channels_.at(topic));
  return found == counts.end() ? 0 : found->second;
}

}  // namespace tocsin::bag
