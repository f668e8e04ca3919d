// SPDX-License-Identifier: Apache-2.0
// The words of the link: streams, samples, transmissions, and what may become of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "foundation/link_path.hpp"
#include "foundation/sample_coding.hpp"
#include "foundation/time.hpp"
#include "foundation/traffic_class.hpp"
#include "link_router/wire_cost.hpp"

namespace tocsin::router {

[[nodiscard]] constexpr std::size_t index_of(TrafficClass traffic_class) {
  return static_cast<std::size_t>(traffic_class);
}

/// What becomes of new samples of a stream while the link is paused.
enum class WhilePaused : std::uint8_t {
  send,    ///< the pause does not concern it
  latest,  ///< the newest of each source waits, and goes on resume
  drop,    ///< counted
};

/// A link writer as both sides know it, unique within one instance of the router that owns it: its
/// RTPS entity id.
using StreamId = std::uint32_t;
/// RTPS sequence number of a stream's link writer on one path: 1, 2, 3, ... One for each
/// transmission, repairs included.
using TransmissionNumber = std::uint64_t;
/// One instance of a router. A restart has another one.
using InstanceId = std::uint64_t;
/// The writer on the host that made a sample; of a topic with keys, the writer and the instance.
using SourceId = std::uint64_t;

/// The origin of a sample. It crosses the link with it.
struct Origin {
  SourceId source = 0;
  std::uint64_t sequence = 0;  ///< of the source, rising, not necessarily by 1
  Time sent{};                 ///< by the clock of the source's host
};

/// A sample on its way.
struct Sample {
  Origin origin;
  std::size_t bytes = 0;                ///< serialised
  std::shared_ptr<const void> content;  ///< the caller's; kept as long as it may be sent again
  SampleCoding coding{};                ///< of the content
};

/// What the configuration says of a stream.
struct StreamRule {
  /// Topic, and user data of the writers if the topic has several kinds: the stream's name over all
  /// instances of a router.
  std::string name;
  TrafficClass traffic_class = TrafficClass::low;
  WhilePaused while_paused = WhilePaused::send;
  std::size_t depth = 1;  ///< newest samples of each source that are kept (KEEP_LAST); at least 1
  Duration lifespan = Duration::max();  ///< an older sample is neither sent nor delivered
  bool repaired = false;    ///< what is missing is sent again; default: ClassPolicy::repaired
  bool durable = false;     ///< the newest sample of each source is sent to peers that come later
  bool adaptive = false;    ///< its source follows the budget
  bool on_demand = false;   ///< what no peer wants is not sent
  bool stored = false;      ///< the fate of each sample is reported, so that the lost ones follow
  bool compressed = false;  ///< its samples are made smaller where that gains something
  PathUse paths = PathUse::best;
};

/// What became of a sample on the link; one that was given up may be delivered all the same.
enum class LiveFate : std::uint8_t {
  delivered,  ///< all peers that want it have it, and there is one
  not_delivered,
};

/// Why a sample was not sent, or not sent again.
enum class DropReason : std::uint8_t {
  paused,      ///< while_paused is `drop`, or a newer one was offered during the pause
  superseded,  ///< a newer one of its source was offered while it waited
  expired,     ///< older than its lifespan before it was sent
  overflow,    ///< its class has more waiting than its bound of bytes
  removed,     ///< its stream was removed
};
inline constexpr std::size_t drop_reason_count = 5;

/// What became of a sample of a stored stream.
struct StoredFate {
  StreamId stream = 0;
  Origin origin;
  LiveFate fate = LiveFate::not_delivered;
};

}  // namespace tocsin::router
