// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "kobuki_protocol/bytes.hpp"

namespace tocsin::kobuki {

inline constexpr std::uint8_t header_0 = 0xAA;
inline constexpr std::uint8_t header_1 = 0x55;
inline constexpr std::size_t min_payload = 3;
inline constexpr std::size_t max_payload = 255;
inline constexpr std::size_t max_frame = max_payload + 4;

/// One frame as on the wire, both directions: AA 55 | LEN | payload | XOR of LEN and payload.
///
/// Written as sub-payloads (ID, SUBLEN, data) and closed once. Fixed size, no allocation.
class Frame {
 public:
  Frame();
  /// Begins a sub-payload of `size` data bytes, which must follow. False, and nothing written, when
  /// it does not fit into the 255 payload bytes.
  [[nodiscard]] bool begin(std::uint8_t id, std::size_t size);
  void u8(std::uint8_t value);
  void u16(std::uint16_t value);
  void u32(std::uint32_t value) {
    u16(static_cast<std::uint16_t>(value & 0xFFFFU));
    u16(static_cast<std::uint16_t>(value >> 16U));
  }
  void i16(std::int16_t value) { u16(static_cast<std::uint16_t>(value)); }
  /// Sets LEN and the checksum. Nothing may be written afterwards.
  void close();

  [[nodiscard]] ByteView bytes() const { return {bytes_.data(), size_}; }
  [[nodiscard]] ByteView payload() const { return {bytes_.data() + 3, payload_size()}; }

 private:
  [[nodiscard]] std::size_t payload_size() const { return size_ - (closed_ ? 4 : 3); }
  std::array<std::uint8_t, max_frame> bytes_{};
  std::size_t size_ = 3;
  bool closed_ = false;
};

/// XOR of all bytes. Over LEN..checksum of a good frame it is 0.
[[nodiscard]] std::uint8_t xor_of(ByteView bytes);

/// One ID, SUBLEN, data inside a payload.
struct SubPayload {
  std::uint8_t id = 0;
  ByteView data;
};

/// What happened to the sub-payloads of a stream.
struct DecodeCounts {
  std::uint64_t known = 0;
  std::uint64_t unknown = 0;    ///< ID not in the tables, skipped by its length
  std::uint64_t malformed = 0;  ///< known ID whose length or content is wrong, skipped
  std::uint64_t truncated = 0;  ///< length runs past the payload: the rest was dropped
};

/// Walks the sub-payloads of one payload.
class SubPayloadReader {
 public:
  explicit SubPayloadReader(ByteView payload) : payload_(payload) {}
  /// The next sub-payload; empty at the end and where a length runs past it.
  [[nodiscard]] std::optional<SubPayload> next();
  /// Whether the walk ended before the last byte.
  [[nodiscard]] bool truncated() const { return truncated_; }

 private:
  ByteView payload_;
  std::size_t at_ = 0;
  bool truncated_ = false;
};

}  // namespace tocsin::kobuki
