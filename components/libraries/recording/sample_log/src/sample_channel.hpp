// SPDX-License-Identifier: Apache-2.0
// How a writer of a stream stands in a segment: as a channel of MCAP.
#pragma once

#include <cstdint>
#include <optional>

#include "sample_log/sample_log.hpp"

namespace tocsin::sample_log {

/// What the messages of a channel have in common. MCAP's sequence numbers have 32 bits.
struct ChannelKey {
  std::uint64_t stream = 0;
  std::uint64_t source = 0;
  std::uint32_t sequence_high = 0;
};
[[nodiscard]] bool operator<(const ChannelKey& one, const ChannelKey& other);

[[nodiscard]] ChannelKey channel_key(const SampleId& id);
[[nodiscard]] SampleId sample_id(const ChannelKey& key, std::uint32_t sequence_low);

[[nodiscard]] mcap::Channel to_channel(const LoggedStream& stream, const ChannelKey& key,
                                       std::uint16_t schema_id);
/// Empty when the channel is not of such a log.
[[nodiscard]] std::optional<ChannelKey> key_of(const mcap::Channel& channel);
[[nodiscard]] LoggedStream stream_of(const mcap::Channel& channel, const mcap::Schema& schema);

}  // namespace tocsin::sample_log
