// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tocsin {

[[nodiscard]] constexpr bool host_is_little_endian() {
  return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;
}

/// Turns round the bytes of each of `count` numbers of `width` bytes.
inline void reverse_bytes(std::uint8_t* numbers, std::size_t width, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::reverse(numbers + i * width, numbers + (i + 1) * width);
  }
}

}  // namespace tocsin
