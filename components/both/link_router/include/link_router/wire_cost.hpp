// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "foundation/sample_piece.hpp"

namespace tocsin::router {

/// [B] of a sample that fit a packet as a piece, behind four bytes of its own.
inline constexpr std::size_t largest_piece = 1188;

/// IP packets in which a sample of `bytes` (serialised), or a piece of it, crosses to one peer, in
/// order, each with all headers from IP on: as Fast DDS 2.9.1 of Debian 12 sends it in RTPS
/// messages of at most 1400 bytes, with the origin that the link's writer adds to each.
[[nodiscard]] std::vector<std::size_t> packets_of(std::size_t bytes, SamplePiece piece = {});
/// The packet of a small message between routers, which has no origin.
[[nodiscard]] std::size_t packet_without_origin(std::size_t bytes);
/// In how many pieces of at most `largest` bytes such a sample crosses; 1: whole, since it fits a
/// packet or would make too many.
[[nodiscard]] std::uint8_t count_pieces(std::size_t bytes, std::size_t largest);

/// What a sample costs on the radio.
struct WireCost {
  std::size_t packets = 0;
  std::size_t bytes = 0;  ///< with all headers from IP on
};
/// Of a sample of `bytes` to one peer, or of a piece of it.
[[nodiscard]] WireCost wire_cost(std::size_t bytes, SamplePiece piece = {});

}  // namespace tocsin::router
