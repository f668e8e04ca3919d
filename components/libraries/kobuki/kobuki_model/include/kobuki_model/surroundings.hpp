// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/wall.hpp"

namespace tocsin::kobuki {

/// Answers what a disc touches: the map bearings (rad) from (x, y) to the nearest point of every
/// obstacle closer than `radius`. Empty when it is free.
using Surroundings = std::function<std::vector<double>(double x_m, double y_m, double radius_m)>;

/// Nothing anywhere.
[[nodiscard]] Surroundings open_floor();

/// Surroundings made of walls.
[[nodiscard]] Surroundings walled(std::vector<geometry::Wall> walls);

}  // namespace tocsin::kobuki
