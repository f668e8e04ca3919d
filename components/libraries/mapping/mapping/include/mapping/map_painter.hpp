// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <vector>

#include "mapping/global_mapper.hpp"
#include "mapping/occupancy_grid.hpp"
#include "navigation/tile_map.hpp"

namespace tocsin::mapping {

/// The map as it grows: paints each scan once, and all of them anew when the nodes have moved.
/// Not thread-safe.
class MapPainter {
 public:
  struct Change {
    navigation::TileMap::Index index;
    navigation::TileMap::Tile tile;
  };
  explicit MapPainter(double resolution_m) : grid_(resolution_m), tiles_(resolution_m) {}

  /// Paints the nodes that are new. Where some of the others have moved by more than half a cell
  /// all are painted anew, which takes a while, if `may_begin_anew`.
  void paint(const GlobalMapper& mapper, bool may_begin_anew);
  /// The tiles that have changed since the last call.
  [[nodiscard]] std::vector<Change> take_changes();
  [[nodiscard]] const navigation::TileMap& tiles() const { return tiles_; }

 private:
  [[nodiscard]] bool has_moved(const GlobalMapper& mapper) const;
  [[nodiscard]] std::set<navigation::TileMap::Index> touched() const;
  [[nodiscard]] navigation::TileMap::Tile tile_at(navigation::TileMap::Index index) const;

  OccupancyGrid grid_;
  std::vector<geometry::Pose> painted_;
  bool is_changed_ = false;  ///< since the changes were taken
  navigation::TileMap tiles_;
};

}  // namespace tocsin::mapping
