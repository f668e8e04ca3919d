// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/wall.hpp"
#include "laser_model/scene.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::bench {

enum class WorldKind { rooms, corridor, clutter };
[[nodiscard]] const char* to_string(WorldKind kind);

/// A building nobody has seen: rooms with doors, rooms along a corridor, or one hall full of boxes.
struct World {
  std::vector<geometry::Wall> walls;
  laser::Obstacles obstacles;
  navigation::OccupancyMap truth;       ///< cells of 0.05 m
  navigation::OccupancyMap walls_only;  ///< what a map of the empty building would show
  geometry::Point start;
};

/// Seeded: the same again. Sides of 6 to 12 m, doors of 0.8 to 1.2 m.
[[nodiscard]] World random_world(WorldKind kind, std::uint64_t seed);

}  // namespace tocsin::bench
