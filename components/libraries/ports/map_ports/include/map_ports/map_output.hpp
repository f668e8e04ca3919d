// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "navigation/occupancy_map.hpp"
#include "navigation/tile_map.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The message of values by place [%], row by row from the origin up, frame map. Asserts that there
/// is one for each cell.
[[nodiscard]] topic::Map::Message grid_message(const navigation::Grid& grid,
                                               std::vector<std::int8_t> percents);

/// The message of a map: occupancies [%] as map_server tells them in mode trinary, frame map.
[[nodiscard]] topic::Map::Message map_message(const navigation::OccupancyMap& map);

/// Member of a component that publishes a map, mostly as it grows: its ports `map`, whole whenever
/// its borders move, and `map_updates`, tiles that have changed since. Used by the component's
/// thread.
class MapOutput {
 public:
  MapOutput(Component& owner, double resolution_m);

  /// Takes a tile; Put::too_large: it is refused.
  navigation::TileMap::Put put(navigation::TileMap::Index index, navigation::TileMap::Tile tile);
  /// Publishes a map that does not grow; false: try again.
  [[nodiscard]] bool publish_whole(const navigation::OccupancyMap& map,
                                   const builtin_interfaces::msg::Time& stamp);
  /// Forgets the map: another one begins.
  void begin(double resolution_m);
  /// Publishes what has changed, at most once in half a second, the whole map in two seconds; for
  /// who comes late, the whole map again within five seconds of a change.
  void publish(const builtin_interfaces::msg::Time& stamp, Time now);
  /// When it is to be called again; Time::max() when nothing waits.
  [[nodiscard]] Time deadline() const;
  [[nodiscard]] const navigation::TileMap& tiles() const { return tiles_; }

 private:
  void publish_grown(const builtin_interfaces::msg::Time& stamp, Time now);
  void publish_tile(navigation::TileMap::Index index, const builtin_interfaces::msg::Time& stamp);

  Output<topic::Map> map_;
  Output<topic::MapUpdates> updates_;
  navigation::TileMap tiles_;
  std::set<navigation::TileMap::Index> changed_;
  navigation::Grid published_;  // whole
  bool is_stale_ = false;       // tiles have changed since then
  Time next_{};
  Time next_whole_{};
};

}  // namespace tocsin
