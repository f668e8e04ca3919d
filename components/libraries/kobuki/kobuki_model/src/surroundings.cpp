// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/surroundings.hpp"

#include <cmath>
#include <utility>

#include "geometry/wall.hpp"

namespace tocsin::kobuki {
Surroundings open_floor() {
  return [](double, double, double) { return std::vector<double>{}; };
}

Surroundings walled(std::vector<geometry::Wall> walls) {
  return [walls = std::move(walls)](double x_m, double y_m, double radius_m) {
    std::vector<double> bearings;
    for (const geometry::Wall& wall : walls) {
      const geometry::Point nearest = nearest_point(wall, {x_m, y_m});
      const double dx = nearest.x_m - x_m;
      const double dy = nearest.y_m - y_m;
      if (dx * dx + dy * dy < radius_m * radius_m) bearings.push_back(std::atan2(dy, dx));
    }
    return bearings;
  };
}

}  // namespace tocsin::kobuki
