// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "foundation/error.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::coverage {

/// A floor with walls around it, `width_m` by `height_m`, turned by `turned_rad` around (0, 0), the
/// middle; a pillar of 0.8 m stands at (0.6, 0.4) of it.
inline navigation::OccupancyMap room(double width_m, double height_m, double turned_rad,
                                     bool has_pillar = true) {
  const double half_m = std::hypot(width_m, height_m) / 2 + 0.3;
  const int side = static_cast<int>(std::ceil(2 * half_m / 0.05));
  const navigation::Grid grid{side, side, 0.05, {-half_m, -half_m}};
  std::vector<navigation::Cell> cells;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const auto p = grid.centre({column, row});
      const double x = std::cos(turned_rad) * p.x_m + std::sin(turned_rad) * p.y_m;
      const double y = std::cos(turned_rad) * p.y_m - std::sin(turned_rad) * p.x_m;
      const double out = std::max(std::abs(x) - width_m / 2, std::abs(y) - height_m / 2);
      const bool is_pillar = has_pillar && std::abs(x - 0.6) < 0.4 && std::abs(y - 0.4) < 0.4;
      cells.push_back(out > 0.1              ? navigation::Cell::unknown
                      : out > 0 || is_pillar ? navigation::Cell::occupied
                                             : navigation::Cell::free);
    }
  }
  return {grid, cells};
}

inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace tocsin::coverage
