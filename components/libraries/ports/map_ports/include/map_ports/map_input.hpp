// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "map_ports/live_map.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Member of a component that follows a map as it grows: its ports `map` and `map_updates`. What is
/// no map is passed over with a warning. Used by the component's thread.
class MapInput {
 public:
  explicit MapInput(Component& owner, WakeMode wake = WakeMode::event_triggered);

  /// Takes what has come. Returns whether the map has changed.
  bool take();
  /// Nothing until a whole one was taken.
  [[nodiscard]] std::optional<navigation::OccupancyMap> map() const { return live_map_.map(); }

 private:
  [[nodiscard]] bool take_whole(const topic::Map::Message& map);
  [[nodiscard]] bool is_taken(const char* what, const std::string& refusal);
  Input<topic::Map> map_;
  OptionalInput<topic::MapUpdates> updates_;
  LiveMap live_map_;
  Logger log_;
};

}  // namespace tocsin
