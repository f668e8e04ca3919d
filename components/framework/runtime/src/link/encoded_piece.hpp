// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

#include "foundation/sample_piece.hpp"
#include "idl_support/raw_type.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// A piece is a DDS sample of its own, so the header of every serialised sample (DDSI-RTPS 2.2,
/// 10.2.1) stands before its bytes.
inline constexpr std::size_t encapsulation_bytes = 4;

[[nodiscard]] inline const EncodedMessage& content_of(const CarriedSample& sample) {
  return *static_cast<const EncodedMessage*>(sample.content.get());
}

/// The bytes of a piece as its writer writes them.
[[nodiscard]] inline EncodedMessage cut_out(const EncodedMessage& whole, SamplePiece piece) {
  EncodedMessage part{{0, 1, 0, 0}};  // CDR, little endian
  const auto begin = whole.bytes.begin();
  const std::size_t bytes = whole.bytes.size();
  part.bytes.insert(part.bytes.end(), begin + static_cast<std::ptrdiff_t>(piece.begin(bytes)),
                    begin + static_cast<std::ptrdiff_t>(piece.end(bytes)));
  return part;
}

/// The sample of which these are the pieces.
[[nodiscard]] inline EncodedMessage put_together(
    const std::vector<std::shared_ptr<const void>>& pieces) {
  EncodedMessage whole;
  for (const auto& piece : pieces) {
    const auto& bytes = static_cast<const EncodedMessage*>(piece.get())->bytes;
    whole.bytes.insert(whole.bytes.end(), bytes.begin() + encapsulation_bytes, bytes.end());
  }
  return whole;
}

}  // namespace tocsin
