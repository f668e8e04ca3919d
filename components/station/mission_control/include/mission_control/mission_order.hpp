// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin {

/// What people ask of a mission while it runs.
struct MissionOrder {
  enum class Kind { pause, resume, skip };
  Kind kind = Kind::pause;
  std::uint32_t waypoint = 0;  ///< of skip: the one to leave out, index from 0
};

/// Of "pause", "resume" or "skip N", N from 1; nothing for other words.
[[nodiscard]] std::optional<MissionOrder> mission_order_of(const std::string& words);

}  // namespace tocsin
