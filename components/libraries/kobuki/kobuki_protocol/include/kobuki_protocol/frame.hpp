// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "foundation/bytes.hpp"

namespace tocsin::kobuki {

inline constexpr std::uint8_t header_0 = 0xAA;
inline constexpr std::uint8_t header_1 = 0x55;
inline constexpr std::size_t min_payload = 3;
inline constexpr std::size_t max_payload = 255;
inline constexpr std::size_t max_frame = max_payload + 4;

/// One frame as on the wire, both directions: AA 55 | LEN | payload | XOR of LEN and payload.
///
/// Made of sub-payloads (ID, SUBLEN, data) and closed once. Fixed size, no allocation.
class Frame {
 public:
  Frame();
  /// Adds a sub-payload of `size` data bytes, which are 0 until they are written. Empty, and
  /// nothing added, when it does not fit into the 255 payload bytes.
  [[nodiscard]] std::optional<ByteWriter> begin(std::uint8_t id, std::size_t size) {
    std::uint8_t* const data = add(id, size);
    if (data == nullptr) return std::nullopt;
    return ByteWriter(data, size);
  }
  /// Sets LEN and the checksum. Nothing may be written afterwards.
  void close();

  [[nodiscard]] ByteView bytes() const { return {bytes_.data(), size_}; }
  [[nodiscard]] ByteView payload() const { return {bytes_.data() + 3, payload_size()}; }

 private:
  /// Where the data goes; null when it does not fit.
  [[nodiscard]] std::uint8_t* add(std::uint8_t id, std::size_t size);
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
