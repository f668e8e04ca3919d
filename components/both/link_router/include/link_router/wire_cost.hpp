// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tocsin::router {

/// IP packets in which a sample of `bytes` (serialised) crosses to one peer, in order, each with
/// all headers from IP on: as Fast DDS 2.9.1 of Debian 12 sends it in RTPS messages of at most 1400
/// bytes, with the origin that the link's writer adds to each.
[[nodiscard]] std::vector<std::size_t> packets_of(std::size_t bytes);

/// What a sample costs on the radio.
struct WireCost {
  std::size_t packets = 0;
  std::size_t bytes = 0;  ///< with all headers from IP on
};
/// Of a sample of `bytes` to one peer.
[[nodiscard]] WireCost wire_cost(std::size_t bytes);

}  // namespace tocsin::router
