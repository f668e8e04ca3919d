// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace tocsin::rtps_filter {

/// Reads numbers of either byte order from bytes that somebody else owns. Reading beyond the end
/// gives zeros, and `ok()` is false from then on.
class Cursor {
 public:
  Cursor() = default;
  Cursor(const std::uint8_t* begin, std::size_t size, bool little)
      : begin_(begin), size_(size), little_(little) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t left() const { return size_ - at_; }
  [[nodiscard]] bool little() const { return little_; }
  [[nodiscard]] const std::uint8_t* here() const { return begin_ + at_; }
  void set_little(bool little) { little_ = little; }

  void skip(std::size_t bytes) { (void)take(bytes); }
  /// To the next multiple of four bytes from the beginning.
  void align() { skip((4 - at_ % 4) % 4); }
  [[nodiscard]] std::uint8_t u8() {
    const std::uint8_t* p = take(1);
    return p == nullptr ? std::uint8_t{0} : p[0];
  }
  [[nodiscard]] std::uint16_t u16() {
    const std::uint8_t* p = take(2);
    if (p == nullptr) return 0;
    return static_cast<std::uint16_t>(little_ ? p[0] | p[1] << 8U : p[0] << 8U | p[1]);
  }
  [[nodiscard]] std::uint32_t u32() {
    const std::uint8_t* p = take(4);
    if (p == nullptr) return 0;
    return little_ ? from(p[3], p[2], p[1], p[0]) : from(p[0], p[1], p[2], p[3]);
  }
  /// An entity id: four octets in the order in which they stand, whatever the byte order.
  [[nodiscard]] std::uint32_t entity() {
    const std::uint8_t* p = take(4);
    return p == nullptr ? 0 : from(p[0], p[1], p[2], p[3]);
  }
  /// A sequence number: high word signed, then low word (RTPS 2.5, 9.4.2.5).
  [[nodiscard]] std::int64_t number() {
    const std::uint64_t high = u32();
    return static_cast<std::int64_t>(high << 32U | u32());
  }
  /// The next bytes as a cursor of their own, which stands behind them; empty when they are not
  /// there.
  [[nodiscard]] Cursor part(std::size_t bytes) {
    const std::uint8_t* p = take(bytes);
    return p == nullptr ? Cursor() : Cursor(p, bytes, little_);
  }

 private:
  static std::uint32_t from(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
    return std::uint32_t{a} << 24U | std::uint32_t{b} << 16U | std::uint32_t{c} << 8U | d;
  }
  const std::uint8_t* take(std::size_t bytes) {
    if (bytes > left()) {
      ok_ = false;
      at_ = size_;
      return nullptr;
    }
    const std::uint8_t* p = begin_ + at_;
    at_ += bytes;
    return p;
  }

  const std::uint8_t* begin_ = nullptr;
  std::size_t size_ = 0;
  std::size_t at_ = 0;
  bool little_ = true;
  bool ok_ = true;
};

}  // namespace tocsin::rtps_filter
