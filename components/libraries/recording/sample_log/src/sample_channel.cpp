// SPDX-License-Identifier: Apache-2.0
#include "sample_channel.hpp"

#include <charconv>
#include <string>
#include <tuple>

namespace tocsin::sample_log {
namespace {

constexpr const char* name_key = "stream";
constexpr const char* source_key = "writer";
constexpr const char* high_key = "sequence_high";
constexpr unsigned low_bits = 32;

std::optional<std::uint64_t> number_at(const mcap::KeyValues& values, const char* key) {
  const auto found = values.find(key);
  if (found == values.end()) return std::nullopt;
  const std::string& text = found->second;
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

}  // namespace

bool operator<(const ChannelKey& one, const ChannelKey& other) {
  return std::tie(one.stream, one.source, one.sequence_high) <
         std::tie(other.stream, other.source, other.sequence_high);
}

ChannelKey channel_key(const SampleId& id) {
  return {id.stream, id.source, static_cast<std::uint32_t>(id.sequence >> low_bits)};
}

SampleId sample_id(const ChannelKey& key, std::uint32_t sequence_low) {
  return {key.stream, key.source,
          static_cast<std::uint64_t>(key.sequence_high) << low_bits | sequence_low};
}

mcap::Channel to_channel(const LoggedStream& stream, const ChannelKey& key,
                         std::uint16_t schema_id) {
  mcap::Channel channel;
  channel.schema_id = schema_id;
  channel.topic = stream.topic;
  channel.message_encoding = "cdr";
  channel.metadata = stream.facts;
  channel.metadata[name_key] = stream.name;
  channel.metadata[source_key] = std::to_string(key.source);
  channel.metadata[high_key] = std::to_string(key.sequence_high);
  return channel;
}

std::optional<ChannelKey> key_of(const mcap::Channel& channel) {
  const auto name = channel.metadata.find(name_key);
  const auto source = number_at(channel.metadata, source_key);
  const auto high = number_at(channel.metadata, high_key);
  if (name == channel.metadata.end() || !source || !high) return std::nullopt;
  return ChannelKey{stream_key(name->second), *source, static_cast<std::uint32_t>(*high)};
}

LoggedStream stream_of(const mcap::Channel& channel, const mcap::Schema& schema) {
  LoggedStream stream{channel.metadata.at(name_key), channel.topic, schema, channel.metadata};
  for (const char* const key : {name_key, source_key, high_key}) stream.facts.erase(key);
  return stream;
}

}  // namespace tocsin::sample_log
