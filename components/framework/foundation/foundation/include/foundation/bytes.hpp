// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

namespace tocsin {

/// Bytes that somebody else owns. Valid as long as the owner leaves them in place.
struct ByteView {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;

  [[nodiscard]] const std::uint8_t* begin() const { return data; }
  [[nodiscard]] const std::uint8_t* end() const { return data + size; }
  [[nodiscard]] std::uint8_t operator[](std::size_t i) const {
    assert(i < size);
    return data[i];
  }
  /// `count` bytes from `offset`; both must lie inside.
  [[nodiscard]] ByteView part(std::size_t offset, std::size_t count) const {
    assert(offset <= size && count <= size - offset);
    return {data + offset, count};
  }
};

/// Reads little-endian numbers one after the other. Reading past the end is our bug: it aborts.
class ByteReader {
 public:
  explicit ByteReader(ByteView bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint8_t u8() { return bytes_[at_++]; }
  [[nodiscard]] std::uint16_t u16() {
    const unsigned low = u8();
    return static_cast<std::uint16_t>(low | (static_cast<unsigned>(u8()) << 8U));
  }
  [[nodiscard]] std::uint32_t u32() {
    const std::uint32_t low = u16();
    return low | (static_cast<std::uint32_t>(u16()) << 16U);
  }
  [[nodiscard]] std::int8_t i8() { return static_cast<std::int8_t>(u8()); }
  [[nodiscard]] std::int16_t i16() { return static_cast<std::int16_t>(u16()); }

 private:
  ByteView bytes_;
  std::size_t at_ = 0;
};

/// Writes little-endian numbers one after the other into a place of `size` bytes. Writing past the
/// end is our bug: it aborts. Inline like the reader, so that where the size is a constant the
/// compiler makes the checks, once.
class ByteWriter {
 public:
  ByteWriter(std::uint8_t* to, std::size_t size) : to_(to), size_(size) {}
  void u8(std::uint8_t value) {
    assert(at_ < size_);
    to_[at_++] = value;
  }
  void u16(std::uint16_t value) {
    u8(static_cast<std::uint8_t>(value & 0xFFU));
    u8(static_cast<std::uint8_t>(value >> 8U));
  }
  void u32(std::uint32_t value) {
    u16(static_cast<std::uint16_t>(value & 0xFFFFU));
    u16(static_cast<std::uint16_t>(value >> 16U));
  }
  void i8(std::int8_t value) { u8(static_cast<std::uint8_t>(value)); }
  void i16(std::int16_t value) { u16(static_cast<std::uint16_t>(value)); }

 private:
  std::uint8_t* to_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace tocsin
