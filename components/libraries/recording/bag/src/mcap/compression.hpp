// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "mcap/byte_sink.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

/// As a chunk names it: empty for none.
[[nodiscard]] std::string name_in_file(Compression compression);

/// False when the result is not smaller; `to` is unspecified then.
[[nodiscard]] bool compress(Compression compression, Span from, Bytes& to);

enum class Unpacked {
  whole,
  part,    ///< what came before the cut or the damage is there
  nothing  ///< of a compression that nobody knows
};

/// Replaces `to` by what `from` was made from, at most `size` bytes. Takes memory as bytes come,
/// not by what the file claims.
[[nodiscard]] Unpacked unpack(const std::string& compression, Span from, std::uint64_t size,
                              Bytes& to);

}  // namespace tocsin::mcap
