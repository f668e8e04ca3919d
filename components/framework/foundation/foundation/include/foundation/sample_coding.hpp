// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace tocsin {

/// How the content of a sample crosses the link.
struct SampleCoding {
  /// A base is at most so far before its sample.
  static constexpr std::uint64_t farthest = 254;
  /// [B] A larger sample is not compressed, and none that claims to be larger is restored.
  static constexpr std::size_t largest = 1U << 20U;

  bool is_compressed = false;  ///< else the bytes that its writer wrote
  /// [0, farthest] It is compressed by what it shares with the sample of its source whose sequence
  /// number is smaller by this, its base; 0: by itself.
  std::uint8_t base = 0;
};
[[nodiscard]] inline bool operator==(const SampleCoding& one, const SampleCoding& other) {
  return one.is_compressed == other.is_compressed && one.base == other.base;
}
/// Of a compressed sample, by the sequence number of its base, if it has one; nothing where that is
/// too far before it.
[[nodiscard]] inline std::optional<SampleCoding> compressed_by(std::uint64_t sequence,
                                                               std::optional<std::uint64_t> base) {
  const std::uint64_t before = base ? sequence - *base : 0;
  if (before > SampleCoding::farthest) return std::nullopt;
  return SampleCoding{true, static_cast<std::uint8_t>(before)};
}

}  // namespace tocsin
