// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "link_router/transmission.hpp"

namespace tocsin::router {

/// Of one traffic class, counted since the start. Samples, unless it says transmissions. At rest
/// offered = sent + dropped + waiting, and sent = delivered + lost +
/// unwanted.
struct ClassCounts {
  std::uint64_t offered = 0;
  std::uint64_t sent = 0;       ///< put on the wire at least once
  std::uint64_t delivered = 0;  ///< every peer that wanted it has it, as the acknowledgements say
  std::uint64_t late = 0;       ///< of delivered: more than 250 ms after it was offered
  std::uint64_t lost = 0;       ///< sent, not delivered to every peer, and given up
  std::uint64_t unwanted = 0;   ///< sent, and no peer wanted it
  std::uint64_t repaired = 0;   ///< of delivered: only by a repair
  std::uint64_t repairs = 0;    ///< transmissions of samples that were sent before
  std::uint64_t repair_bytes = 0;  ///< [B] of them on the wire, as wire_cost() has it
  std::array<std::uint64_t, drop_reason_count> dropped{};  ///< by DropReason
  std::size_t waiting_samples = 0;                         ///< now, in the router
  std::size_t waiting_bytes = 0;                           ///< now, serialised
  /// Of the last delivered one: one-way delay over the least that was seen lately.
  std::optional<Duration> delay;
};

/// Of one stream, counted since it was added: offered = sent + dropped + waiting.
struct StreamCounts {
  std::uint64_t offered = 0;
  std::uint64_t sent = 0;     ///< put on the wire at least once
  std::uint64_t dropped = 0;  ///< never sent, for whatever reason
  std::uint64_t paused = 0;   ///< of dropped: DropReason::paused
};

/// What the router knows of one of two paths.
struct PathValues {
  bool chosen = false;              ///< first transmissions go by it
  bool silent = false;              ///< no peer acknowledges what goes by it
  double capacity_bytes_per_s = 0;  ///< [B/s] estimate, of the slowest live peer
  Duration backlog{0};              ///< what is in its radio's queue, by the estimate
  double loss = 0;                  ///< [0, 1] recent share of transmissions that were lost
  std::optional<Duration> delay;    ///< of small samples, over the least of both; of a known one
};

/// What the router knows of the link and does about it. Where there are two paths, the numbers of
/// one are of the chosen.
struct LinkStateValues {
  std::array<ClassCounts, traffic_classes.size()> classes;
  double capacity_bytes_per_s = 0;  ///< [B/s] estimate, headers included; of the slowest live peer
  bool capacity_measured = false;   ///< else it is what the parameters assume
  Duration backlog{0};              ///< what is in the radio's queue, by the estimate
  double loss = 0;                  ///< [0, 1] recent share of transmissions that were lost
  double scale = 1;                 ///< [0.25, 1] of the adaptive streams
  double repair_share = 0;          ///< [0, 1] of the capacity, recently spent on repairs
  bool paused = false;
  std::size_t live_peers = 0;     ///< that acknowledge what they get
  std::size_t silent_peers = 0;   ///< known, but they do not
  std::vector<PathValues> paths;  ///< where there are two
};

}  // namespace tocsin::router
