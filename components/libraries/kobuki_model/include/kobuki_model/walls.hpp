// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace tocsin::kobuki {

/// A wall as a segment in the map frame. A radio model may use the loss; here it has no meaning.
struct Wall {
  double x1_m = 0;
  double y1_m = 0;
  double x2_m = 0;
  double y2_m = 0;
  double loss_db = 0;
};

/// Answers what a disc touches: the map bearings (rad) from (x, y) to the nearest point of every
/// obstacle closer than `radius`. Empty when it is free.
using Surroundings = std::function<std::vector<double>(double x_m, double y_m, double radius_m)>;

/// Nothing anywhere.
[[nodiscard]] Surroundings open_floor();

/// Surroundings made of walls.
[[nodiscard]] Surroundings walled(std::vector<Wall> walls);

}  // namespace tocsin::kobuki
