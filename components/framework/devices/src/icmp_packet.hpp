// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tocsin::network {

/// What identifies one of our echo requests, and the reply to it.
struct Echo {
  std::uint16_t id = 0;
  std::uint16_t sequence = 0;
  std::uint64_t token = 0;  ///< in the payload: tells our replies from those of another process
};

/// Smallest payload: the token.
inline constexpr std::size_t min_echo_payload = 8;

/// The Internet checksum (RFC 1071) of `size` bytes, in host order. Zero over a packet that holds
/// its own correct checksum.
[[nodiscard]] std::uint16_t internet_checksum(const std::uint8_t* data, std::size_t size);

/// An ICMPv4 echo request (RFC 792) of 8 + `payload_bytes` bytes; `payload_bytes` is at least
/// `min_echo_payload`.
[[nodiscard]] std::vector<std::uint8_t> encode_echo_request(const Echo& echo,
                                                            std::size_t payload_bytes);

/// An echo reply without its IP header. Empty for anything else: too short, another type, wrong
/// checksum, payload too small for the token.
[[nodiscard]] std::optional<Echo> decode_echo_reply(const std::uint8_t* data, std::size_t size);

/// The length of the IPv4 header at the start of a raw packet; empty when there is none, or when
/// it is longer than the packet.
[[nodiscard]] std::optional<std::size_t> ipv4_header_size(const std::uint8_t* data,
                                                          std::size_t size);

}  // namespace tocsin::network
