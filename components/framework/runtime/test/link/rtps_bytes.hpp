// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace tocsin {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t data = 0x15;
inline constexpr std::uint8_t fragment = 0x16;
inline constexpr std::uint8_t acknack = 0x06;
inline constexpr std::uint8_t heartbeat = 0x07;
inline constexpr std::uint8_t info_timestamp = 0x09;
inline constexpr std::uint8_t info_destination = 0x0e;
inline constexpr std::uint8_t of_vendor = 0x80;

/// The header of an RTPS message.
inline Bytes message() {
  Bytes bytes{'R', 'T', 'P', 'S', 2, 3, 1, 15};
  bytes.resize(20);
  return bytes;
}

inline void append(Bytes& to, std::uint8_t kind, const Bytes& content, bool little_endian = true) {
  const auto low = static_cast<std::uint8_t>(content.size() & 0xFFU);
  const auto high = static_cast<std::uint8_t>(content.size() >> 8U);
  to.insert(to.end(), {kind, static_cast<std::uint8_t>(little_endian ? 1 : 0),
                       little_endian ? low : high, little_endian ? high : low});
  to.insert(to.end(), content.begin(), content.end());
}

/// Extra flags and octets to inline QoS, reader, writer, and something behind.
inline Bytes data_of(std::uint8_t writer) {
  return {0, 0, 16, 0, 0, 0, 0, 0, 0, 0, writer, 0x03, 1, 2, 3, 4, 5, 6, 7, 8};
}
/// Reader, writer, and something behind.
inline Bytes ends(std::uint8_t reader, std::uint8_t writer) {
  return {0, 0, reader, 0x04, 0, 0, writer, 0x03, 0, 0, 0, 0};
}

}  // namespace tocsin
