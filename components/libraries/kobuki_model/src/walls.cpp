// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tocsin::kobuki {
namespace {

struct Offset {
  double x_m;
  double y_m;
};

/// From (x, y) to the nearest point of the wall.
Offset offset_to(const Wall& wall, double x_m, double y_m) {
  const double dx = wall.x2_m - wall.x1_m;
  const double dy = wall.y2_m - wall.y1_m;
  const double length2 = dx * dx + dy * dy;
  double along = 0;
  if (length2 > 0) along = ((x_m - wall.x1_m) * dx + (y_m - wall.y1_m) * dy) / length2;
  along = std::clamp(along, 0.0, 1.0);
  return {wall.x1_m + along * dx - x_m, wall.y1_m + along * dy - y_m};
}

}  // namespace

Surroundings open_floor() {
  return [](double, double, double) { return std::vector<double>{}; };
}

Surroundings walled(std::vector<Wall> walls) {
  return [walls = std::move(walls)](double x_m, double y_m, double radius_m) {
    std::vector<double> bearings;
    for (const Wall& wall : walls) {
      const Offset offset = offset_to(wall, x_m, y_m);
      if (offset.x_m * offset.x_m + offset.y_m * offset.y_m >= radius_m * radius_m) continue;
      bearings.push_back(std::atan2(offset.y_m, offset.x_m));
    }
    return bearings;
  };
}

}  // namespace tocsin::kobuki
