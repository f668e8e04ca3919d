// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tocsin::decision {

/// The chance that the link is lost along the way ahead, as a map foretells it: now, and each
/// second from now on.
struct Outlook {
  static constexpr std::size_t most = 61;
  std::array<std::uint8_t, most> risk_percent{};  ///< [range 0,100]
  std::size_t size = 0;                           ///< of them that are known; 0: nothing is
};

}  // namespace tocsin::decision
