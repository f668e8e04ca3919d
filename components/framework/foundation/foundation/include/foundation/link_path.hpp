// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "foundation/enum_words.hpp"

namespace tocsin {

/// A way over the link: one interface of a host and one of each peer. 0 is the first, which every
/// router has; 1 is the second, such as a modem beside the Wi-Fi.
using PathIndex = std::uint8_t;
inline constexpr std::size_t most_paths = 2;
/// The one of two that is not this.
[[nodiscard]] constexpr PathIndex other_path(PathIndex path) {
  return static_cast<PathIndex>(1 - path);
}

/// Which paths the samples of a class take, where there are two.
enum class PathUse : std::uint8_t {
  best,    ///< all go by the better one
  repair,  ///< what is sent again goes by the other
  both,    ///< and first copies go by both while the better one is poor
};

inline constexpr auto words_of(PathUse) { return std::array{"best", "repair", "both"}; }

}  // namespace tocsin
