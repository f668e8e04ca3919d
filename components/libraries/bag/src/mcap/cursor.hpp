// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "mcap/byte_sink.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

/// Reads little-endian fields of bytes that may lie. What is not there reads as 0 or empty, and
/// from then on everything does.
class Cursor {
 public:
  explicit Cursor(Span bytes) : bytes_(bytes) {}

  [[nodiscard]] std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  [[nodiscard]] std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  [[nodiscard]] std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  [[nodiscard]] std::uint64_t u64() { return number(8); }
  /// Behind a length of 4 bytes.
  [[nodiscard]] std::string text();
  /// Pairs of texts behind a length of 4 bytes.
  [[nodiscard]] KeyValues key_values();
  [[nodiscard]] Span take(std::uint64_t size);
  [[nodiscard]] std::size_t left() const { return bytes_.size - at_; }
  [[nodiscard]] std::size_t at() const { return at_; }
  /// Whether everything so far was there.
  [[nodiscard]] bool good() const { return good_; }

 private:
  [[nodiscard]] std::uint64_t number(std::size_t size);

  Span bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

}  // namespace tocsin::mcap
