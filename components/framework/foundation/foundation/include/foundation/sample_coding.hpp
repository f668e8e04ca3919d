// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tocsin {

/// How the content of a sample crosses the link.
struct SampleCoding {
  /// A base is at most so far before its sample.
  static constexpr std::uint64_t farthest = 254;

  bool is_compressed = false;  ///< else the bytes that its writer wrote
  /// [0, farthest] It is compressed by what it shares with the sample of its source whose sequence
  /// number is smaller by this, its base; 0: by itself.
  std::uint8_t base = 0;
};
[[nodiscard]] inline bool operator==(const SampleCoding& one, const SampleCoding& other) {
  return one.is_compressed == other.is_compressed && one.base == other.base;
}

}  // namespace tocsin
