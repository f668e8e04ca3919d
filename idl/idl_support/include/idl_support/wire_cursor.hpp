// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace tocsin {

/// Walks over the bytes of an encoded message (XCDR1, either byte order) without decoding them.
///
/// Fast CDR makes a sequence as long as its bytes claim before it looks how many there are, so that
/// a forged packet of 100 bytes could take gigabytes. Every message is walked first.
class WireCursor {
 public:
  /// `bytes` begin with the 4-byte encapsulation header.
  WireCursor(const std::uint8_t* bytes, std::size_t size)
      : bytes_(bytes), size_(size), little_(size > 1 && (bytes[1] & 1U) != 0) {}

  [[nodiscard]] bool has_header() const { return size_ >= header; }
  /// Passes `count` values of `width` bytes (a power of two). False when they are not all there.
  [[nodiscard]] bool skip(std::size_t count, std::size_t width) {
    if (count == 0) return true;
    const std::size_t aligned = header + (at_ - header + width - 1) / width * width;
    if (aligned > size_ || count > (size_ - aligned) / width) return false;
    at_ = aligned + count * width;
    return true;
  }
  /// Reads the length in front of a string or sequence. False when it is not there.
  [[nodiscard]] bool read_length(std::uint32_t& length) {
    if (!skip(1, sizeof length)) return false;
    const std::uint8_t* const b = bytes_ + at_ - sizeof length;
    const auto join = [&](int first, int second, int third, int fourth) {
      return static_cast<std::uint32_t>(b[first]) | static_cast<std::uint32_t>(b[second]) << 8U |
             static_cast<std::uint32_t>(b[third]) << 16U |
             static_cast<std::uint32_t>(b[fourth]) << 24U;
    };
    length = little_ ? join(0, 1, 2, 3) : join(3, 2, 1, 0);
    return true;
  }

 private:
  static constexpr std::size_t header = 4;
  const std::uint8_t* bytes_;
  std::size_t size_;
  bool little_;
  std::size_t at_ = header;
};

}  // namespace tocsin
