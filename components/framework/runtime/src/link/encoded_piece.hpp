// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

#include "foundation/sample_piece.hpp"
#include "idl_support/raw_type.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// A piece is a DDS sample of its own, so the header of every serialised sample (DDSI-RTPS 2.2,
/// 10.2.1) stands before its bytes. Its last two bits tell how many zeros the middleware adds
/// behind them, up to a multiple of four (DDS-XTypes 1.3, 7.6.3.1.2).
inline constexpr std::size_t encapsulation_bytes = 4;

[[nodiscard]] inline const EncodedMessage& content_of(const CarriedSample& sample) {
  return *static_cast<const EncodedMessage*>(sample.content.get());
}

/// The bytes of a piece as its writer writes them.
[[nodiscard]] inline EncodedMessage cut_out(const EncodedMessage& whole, SamplePiece piece) {
  const std::size_t bytes = whole.bytes.size();
  const auto padding = static_cast<std::uint8_t>((4 - piece.size(bytes) % 4) % 4);
  EncodedMessage part{{0, 1, 0, padding}};  // CDR, little endian
  const auto begin = whole.bytes.begin();
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
    const std::size_t padding = bytes.size() % 4 == 0 ? bytes[encapsulation_bytes - 1] & 3U : 0;
    const auto end = bytes.end() - static_cast<std::ptrdiff_t>(
                                       std::min(padding, bytes.size() - encapsulation_bytes));
    whole.bytes.insert(whole.bytes.end(), bytes.begin() + encapsulation_bytes, end);
  }
  return whole;
}

}  // namespace tocsin
