// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "idl_support/byte_order.hpp"

namespace tocsin {

enum class ByteOrder { little, big };

/// Writes numbers as XCDR1 has them (DDS-XTypes 1.3, section 7.4.1): each at a multiple of its size
/// from the begin of the message, and zeros between. Writes nothing beyond its capacity.
class WireWriter {
 public:
  WireWriter(std::uint8_t* bytes, std::size_t capacity, ByteOrder order)
      : bytes_(bytes),
        capacity_(capacity),
        swaps_((order == ByteOrder::little) != host_is_little_endian()) {}

  /// False when there is no room, and nothing is written from then on.
  template <class Number>
  bool write(const Number* numbers, std::size_t count) {
    if (count == 0) return true;
    const std::size_t begin = (size_ + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number);
    const std::size_t bytes = count * sizeof(Number);
    if (begin > capacity_ || bytes > capacity_ - begin) {
      capacity_ = 0;
      return false;
    }
    std::memset(bytes_ + size_, 0, begin - size_);
    std::memcpy(bytes_ + begin, numbers, bytes);
    if (swaps_) reverse_bytes(bytes_ + begin, sizeof(Number), count);
    size_ = begin + bytes;
    return true;
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::uint8_t* bytes_;
  std::size_t capacity_;
  bool swaps_;
  std::size_t size_ = 0;
};

/// Counts what WireWriter would write.
class WireSize {
 public:
  template <class Number>
  bool write(const Number* /*numbers*/, std::size_t count) {
    if (count == 0) return true;
    size_ = (size_ + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number) + count * sizeof(Number);
    return true;
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

}  // namespace tocsin
