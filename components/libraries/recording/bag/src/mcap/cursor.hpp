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

  /// Of `size` bytes, 8 at most.
  [[nodiscard]] std::uint64_t number(std::size_t size);
  /// Behind a length of 4 bytes.
  [[nodiscard]] std::string text();
  [[nodiscard]] Span take(std::uint64_t size);
  [[nodiscard]] std::size_t left() const { return bytes_.size - at_; }
  [[nodiscard]] std::size_t at() const { return at_; }
  /// Whether everything so far was there.
  [[nodiscard]] bool good() const { return good_; }
  void fail() { good_ = false; }

 private:
  Span bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

}  // namespace tocsin::mcap
