// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "navigation/tile_map.hpp"

namespace tocsin {

/// In which order the tiles of a growing map are sent over a link that may lose them: those that
/// have changed first, the longest waiting one before, then all of them in turn, so that who comes
/// late, and who has missed one, has the map after a while. Pure.
class TileQueue {
 public:
  using Index = navigation::TileMap::Index;

  void on_change(Index index);
  /// The tile that has changed and waits longest; empty: none.
  [[nodiscard]] std::optional<Index> next_changed();
  /// The tile that was sent longest ago; empty: there is none, or one that has changed waits.
  [[nodiscard]] std::optional<Index> next_repeat();

 private:
  std::uint64_t turn_ = 0;
  std::map<Index, std::uint64_t> changed_;  ///< since which turn
  std::map<Index, std::uint64_t> sent_;     ///< in which turn
};

}  // namespace tocsin
