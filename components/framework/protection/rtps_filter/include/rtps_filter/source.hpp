// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tocsin::rtps_filter {

/// Where a UDP packet came from.
struct Source {
  std::uint32_t address = 0;  ///< IPv4, host byte order: 0x7f000001 is 127.0.0.1
  std::uint16_t port = 0;
};

[[nodiscard]] constexpr bool operator==(const Source& one, const Source& other) {
  return one.address == other.address && one.port == other.port;
}
[[nodiscard]] constexpr bool operator!=(const Source& one, const Source& other) {
  return !(one == other);
}

[[nodiscard]] constexpr std::uint32_t ipv4(std::uint8_t a, std::uint8_t b, std::uint8_t c,
                                           std::uint8_t d) {
  return std::uint32_t{a} << 24U | std::uint32_t{b} << 16U | std::uint32_t{c} << 8U | d;
}

/// Whose socket a packet came from that was sent on this computer.
enum class Sender : std::uint8_t {
  trusted,  ///< of a user who may speak, or of another computer
  other,    ///< of somebody else
  gone,     ///< nobody has the socket any more, or somebody who hides it
};

/// Dotted: "127.0.0.1".
[[nodiscard]] std::string to_text(std::uint32_t address);

}  // namespace tocsin::rtps_filter
