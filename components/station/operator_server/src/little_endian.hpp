// SPDX-License-Identifier: Apache-2.0
// Numbers as they stand in binary frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tocsin::foxglove {

/// Takes numbers and texts off the front of a frame.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  /// Nothing when the bytes end before it does.
  template <class Number>
  [[nodiscard]] std::optional<Number> take() {
    if (bytes_.size() < sizeof(Number)) return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t i = sizeof(Number); i-- > 0;) {
      value = value << 8U | static_cast<std::uint8_t>(bytes_[i]);
    }
    bytes_.remove_prefix(sizeof(Number));
    return static_cast<Number>(value);
  }
  [[nodiscard]] std::optional<std::string_view> take_text(std::size_t size) {
    if (bytes_.size() < size) return std::nullopt;
    const std::string_view text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return text;
  }
  [[nodiscard]] std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

template <class Number>
void append(std::string& frame, Number value) {
  auto wide = static_cast<std::uint64_t>(value);
  for (std::size_t i = 0; i < sizeof(Number); ++i, wide >>= 8U) {
    frame.push_back(static_cast<char>(wide & 0xffU));
  }
}

}  // namespace tocsin::foxglove
