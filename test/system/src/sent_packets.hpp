// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "packet_tap.hpp"

namespace tocsin {

/// What a packet of a router is.
struct Sent {
  std::int64_t time_ns;
  std::size_t bytes;
  int dscp;
  bool discovery;
  std::uint8_t kind;  ///< of its first submessage that names a sender
  std::string topic;  ///< ROS name; empty: of discovery, or of a writer that was not announced yet
};

/// The RTPS packets that a host has sent after `since_ns`, of lives that began after it.
[[nodiscard]] std::vector<Sent> sent(const PacketTap& tap, std::int64_t since_ns);

/// Packets of a topic after `since_ns` with samples in them.
[[nodiscard]] std::size_t count(const std::vector<Sent>& packets, const std::string& topic,
                                std::int64_t since_ns);

/// Endpoints that the host's router has announced after `since_ns`.
[[nodiscard]] std::size_t announcements(const PacketTap& tap, std::int64_t since_ns);

}  // namespace tocsin
