// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>
#include <vector>

namespace tocsin {

/// A UDP socket of IPv4 among this process's descriptors.
struct OwnSocket {
  int descriptor;
  std::uint16_t port;
};

/// All of them. Another thread may close one meanwhile.
[[nodiscard]] std::vector<OwnSocket> own_udp_sockets();

/// Ports of those in which bytes wait to be read.
[[nodiscard]] std::set<std::uint16_t> unread_ports();

}  // namespace tocsin
