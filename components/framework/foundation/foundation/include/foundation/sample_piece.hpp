// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tocsin {

/// A part of a sample that crosses the link by itself, so that the loss of a packet costs one
/// packet. All pieces of a sample are equally long, but for the last.
struct SamplePiece {
  /// Pieces of a sample: an acknowledgement can name all of them, and those of the sample before.
  static constexpr std::size_t most = 48;

  std::uint8_t index = 0;  ///< [0, count)
  std::uint8_t count = 1;  ///< [1, most]; 1: the whole sample

  [[nodiscard]] bool is_whole() const { return count == 1; }
  [[nodiscard]] bool is_last() const { return index + 1 == count; }
  /// Where it begins in a sample of `bytes`, and where it ends.
  [[nodiscard]] std::size_t begin(std::size_t bytes) const { return cut(index, bytes); }
  [[nodiscard]] std::size_t end(std::size_t bytes) const { return cut(index + 1U, bytes); }
  [[nodiscard]] std::size_t size(std::size_t bytes) const { return end(bytes) - begin(bytes); }

 private:
  [[nodiscard]] std::size_t cut(std::size_t pieces, std::size_t bytes) const {
    const std::size_t length = (bytes + count - 1) / count;
    return std::min(pieces * length, bytes);
  }
};
[[nodiscard]] inline bool operator==(const SamplePiece& one, const SamplePiece& other) {
  return one.index == other.index && one.count == other.count;
}

}  // namespace tocsin
