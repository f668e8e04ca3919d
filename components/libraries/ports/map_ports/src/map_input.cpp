// SPDX-License-Identifier: Apache-2.0
#include "map_ports/map_input.hpp"

#include <cmath>
#include <limits>

#include "geometry/pose_message.hpp"

namespace tocsin {
namespace {

constexpr double most_turn_rad = 1e-3;  // of a map's rows

/// -1: more than an int holds.
int size_of(std::uint32_t cells) {
  return cells <= std::uint32_t{std::numeric_limits<int>::max()} ? static_cast<int>(cells) : -1;
}

}  // namespace

MapInput::MapInput(Component& owner, WakeMode wake)
    : map_(owner, wake), updates_(owner, wake), log_(owner.name(), owner.node()) {}

bool MapInput::take() {
  bool has_changed = false;
  if (const auto map = map_.take_latest()) has_changed = take_whole(*map);
  while (const auto tile = updates_.take()) {
    const LiveMap::Tile place{tile->x(), tile->y(), tile->width(), tile->height()};
    const std::string refusal = live_map_.update(place, tile->data());
    has_changed = is_taken("a tile of the map", refusal) || has_changed;
  }
  return has_changed;
}

bool MapInput::take_whole(const topic::Map::Message& map) {
  const auto& info = map.info();
  const geometry::Pose origin = geometry::pose_in(info.origin());
  const bool is_turned = !(std::abs(origin.heading_rad) <= most_turn_rad);
  if (is_turned) return is_taken("a map", "its rows are turned");
  return is_taken("a map", live_map_.replace({size_of(info.width()), size_of(info.height()),
                                              info.resolution(), position(origin)},
                                             map.data()));
}

bool MapInput::is_taken(const char* what, const std::string& refusal) {
  if (!refusal.empty()) log_.warn("{} is ignored: {}", what, refusal);
  return refusal.empty();
}

}  // namespace tocsin
