// SPDX-License-Identifier: Apache-2.0
#include "active_segment.hpp"

#include <limits>

namespace tocsin::sample_log {

mcap::WriterOptions SampleLog::Active::options() {
  mcap::WriterOptions options;
  options.profile = "ros2";
  // Each append is a chunk of its own, so that a kill takes nothing that was appended.
  options.chunk_bytes = std::numeric_limits<std::size_t>::max();
  return options;
}

std::optional<std::uint16_t> SampleLog::Active::channel_of(
    const SampleId& id, const std::map<std::uint64_t, LoggedStream>& streams) {
  const ChannelKey key = channel_key(id);
  const auto known = channels_.find(key);
  if (known != channels_.end()) return known->second;
  const auto stream = streams.find(id.stream);
  if (stream == streams.end()) return std::nullopt;
  const auto [schema, is_new] = schemas_.try_emplace(id.stream, 0);
  if (is_new) schema->second = writer_.declare(stream->second.schema).value_or(0);
  const auto made = writer_.declare(to_channel(stream->second, key, schema->second));
  if (made) channels_[key] = *made;
  return made;
}

mcap::Kept SampleLog::Active::append(
    const std::vector<std::pair<const LogEntry*, std::uint64_t>>& entries,
    const std::map<std::uint64_t, LoggedStream>& streams) {
  std::vector<std::uint16_t> channels;
  for (const auto& entry : entries) {
    const auto channel = channel_of(entry.first->id, streams);
    if (!channel) return mcap::Kept::nothing;
    channels.push_back(*channel);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LogEntry& entry = *entries[i].first;
    (void)writer_.write(mcap::Message{
        channels[i], static_cast<std::uint32_t>(entry.id.sequence), entries[i].second,
        static_cast<std::uint64_t>(entry.sent_wall_ns), entry.bytes.data(), entry.bytes.size()});
  }
  return writer_.flush();
}

}  // namespace tocsin::sample_log
