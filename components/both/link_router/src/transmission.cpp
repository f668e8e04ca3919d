// SPDX-License-Identifier: Apache-2.0
#include "link_router/transmission.hpp"

#include <numeric>

#include "rtps_model/message.hpp"

namespace tocsin::router {
namespace {

/// Inline QoS of a DATA or DATA_FRAG with a related sample identity: its parameter (4 + 24 bytes)
/// and the sentinel (DDSI-RTPS 2.2, 9.4.2.11).
constexpr std::size_t origin_bytes = 32;

}  // namespace

WireCost wire_cost(std::size_t bytes) {
  const auto packets = rtps::packets_of(bytes, 1, rtps::wire::largest_payload - origin_bytes);
  return {packets.size(), std::accumulate(packets.begin(), packets.end(), std::size_t{0}) +
                              packets.size() * origin_bytes};
}

}  // namespace tocsin::router
