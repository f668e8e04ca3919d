// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "idl_support/byte_order.hpp"

namespace tocsin {

/// Reads the bytes of an encoded message (XCDR1, either byte order), and never beyond them.
/// Nothing has to be made before it is known that its bytes are there: a forged packet of 100 bytes
/// that claims a sequence of gigabytes takes no memory.
class WireCursor {
 public:
  /// `bytes` begin with the 4-byte encapsulation header.
  WireCursor(const std::uint8_t* bytes, std::size_t size)
      : bytes_(bytes), size_(size), little_(size > 1 && (bytes[1] & 1U) != 0) {}

  /// Whether the header is that of plain XCDR1 (RTPS 2.2, section 10.2).
  [[nodiscard]] bool has_header() const {
    return size_ >= header && bytes_[0] == 0 && bytes_[1] <= 1;
  }
  /// Whether `count` values of `width` bytes (a power of two) are there.
  [[nodiscard]] bool has(std::size_t count, std::size_t width) const {
    const std::size_t begin = aligned(width);
    return count == 0 || (begin <= size_ && count <= (size_ - begin) / width);
  }
  /// Passes them. False when they are not all there.
  [[nodiscard]] bool skip(std::size_t count, std::size_t width) {
    if (!has(count, width)) return false;
    if (count > 0) at_ = aligned(width) + count * width;
    return true;
  }
  /// Reads `count` numbers. False, and nothing is read, when they are not all there.
  template <class Number>
  [[nodiscard]] bool read(Number* to, std::size_t count) {
    if (!skip(count, sizeof(Number))) return false;
    if (count == 0) return true;
    std::memcpy(to, bytes_ + at_ - count * sizeof(Number), count * sizeof(Number));
    if (little_ != host_is_little_endian()) {
      reverse_bytes(reinterpret_cast<std::uint8_t*>(to), sizeof(Number), count);
    }
    return true;
  }
  /// Reads the length in front of a string or sequence. False when it is not there.
  [[nodiscard]] bool read_length(std::uint32_t& length) { return read(&length, 1); }

 private:
  static constexpr std::size_t header = 4;
  [[nodiscard]] std::size_t aligned(std::size_t width) const {
    return header + (at_ - header + width - 1) / width * width;
  }
  const std::uint8_t* bytes_;
  std::size_t size_;
  bool little_;
  std::size_t at_ = header;
};

}  // namespace tocsin
