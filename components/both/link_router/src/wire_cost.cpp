// SPDX-License-Identifier: Apache-2.0
#include "link_router/wire_cost.hpp"

#include <algorithm>
#include <numeric>

namespace tocsin::router {
namespace {

// What stands around a sample, in bytes (DDSI-RTPS 2.2, 9.4; captured on the demo's wlan0).
constexpr std::size_t ip_and_udp = 28;
constexpr std::size_t message_header = 20;
constexpr std::size_t info_destination = 16;  ///< one participant is addressed
constexpr std::size_t info_timestamp = 12;
constexpr std::size_t data_header = 24;
constexpr std::size_t data_fragment_header = 36;
constexpr std::size_t heartbeat = 32;
/// Fast DDS keeps room for a submessage of statistics, which the runtime does not let out.
constexpr std::size_t statistics = 60;
/// Inline QoS of a DATA or DATA_FRAG with a related sample identity: its parameter (4 + 24 bytes)
/// and the sentinel (9.4.2.11).
constexpr std::size_t origin = 32;
constexpr std::size_t longest_message = 1400;  ///< without IP and UDP; the runtime sets it
/// Most of a sample that fits a message: Fast DDS keeps room for a destination and a heartbeat, and
/// measures whole samples as if they were fragments.
constexpr std::size_t largest_payload = longest_message - message_header - info_destination -
                                        info_timestamp - data_fragment_header - heartbeat -
                                        statistics - origin;
constexpr std::size_t piece_header = 4;  ///< of a serialised sample, which a piece is
static_assert(largest_piece + piece_header <= largest_payload);
constexpr std::size_t around =
    ip_and_udp + message_header + info_destination + info_timestamp + origin;

constexpr std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

}  // namespace

std::vector<std::size_t> packets_of(std::size_t bytes, SamplePiece piece) {
  if (!piece.is_whole()) return packets_of(piece.size(bytes) + piece_header);
  if (bytes <= largest_payload) return {around + data_header + padded(bytes)};
  std::vector<std::size_t> packets;
  for (std::size_t left = bytes; left > 0; left -= std::min(left, largest_payload)) {
    packets.push_back(around + data_fragment_header + padded(std::min(left, largest_payload)));
  }
  return packets;
}

std::size_t packet_without_origin(std::size_t bytes) {
  return around - origin + data_header + padded(bytes);
}

std::uint8_t count_pieces(std::size_t bytes, std::size_t largest) {
  if (bytes <= largest_payload || largest == 0) return 1;
  const std::size_t pieces = (bytes + largest - 1) / largest;
  return pieces <= SamplePiece::most ? static_cast<std::uint8_t>(pieces) : 1;
}

WireCost wire_cost(std::size_t bytes, SamplePiece piece) {
  const auto packets = packets_of(bytes, piece);
  return {packets.size(), std::accumulate(packets.begin(), packets.end(), std::size_t{0})};
}

}  // namespace tocsin::router
