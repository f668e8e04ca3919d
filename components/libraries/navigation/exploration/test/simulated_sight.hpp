// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "foundation/numbers.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::exploration {

/// A map drawn in text, the top row first: '#' occupied, '.' free, '?' unknown; origin (0, 0).
inline navigation::OccupancyMap drawn(const std::vector<std::string>& rows, double cell_m = 0.1) {
  using navigation::Cell;
  const navigation::Grid grid{int(rows.front().size()), int(rows.size()), cell_m, {0, 0}};
  std::vector<Cell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      cells.push_back(c == '#' ? Cell::occupied : c == '.' ? Cell::free : Cell::unknown);
    }
  }
  return {grid, cells};
}

/// Two rooms and a corridor that leads to both, 6 m by 4 m, in cells of 0.1 m.
inline navigation::OccupancyMap two_rooms() {
  std::vector<std::string> rows(40, std::string(60, '.'));
  const auto wall = [&](int row, int from, int to) {
    for (int column = from; column < to; ++column)
      rows[std::size_t(row)][std::size_t(column)] = '#';
  };
  wall(0, 0, 60);
  wall(39, 0, 60);
  wall(26, 0, 10);
  wall(26, 20, 40);
  wall(26, 50, 60);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    rows[row].front() = rows[row].back() = '#';
    if (row < 26) rows[row][30] = '#';
  }
  return drawn(rows);
}

/// What one sees of a map who looks around in it.
class SimulatedSight {
 public:
  SimulatedSight(navigation::OccupancyMap truth, double range_m)
      : truth_(std::move(truth)),
        range_m_(range_m),
        known_(truth_.grid().size(), navigation::Cell::unknown) {}

  void look(const geometry::Point& from) {
    const double step_m = truth_.grid().resolution_m / 2;
    for (int i = 0; i < 360; ++i) {
      const double bearing_rad = i * degree;
      for (double at_m = 0; at_m < range_m_; at_m += step_m) {
        const auto cell = truth_.grid().cell_of(
            {from.x_m + at_m * std::cos(bearing_rad), from.y_m + at_m * std::sin(bearing_rad)});
        if (!cell) break;
        known_[truth_.grid().offset(*cell)] = truth_.at(*cell);
        if (truth_.at(*cell) == navigation::Cell::occupied) break;
      }
    }
  }
  [[nodiscard]] navigation::OccupancyMap map() const { return {truth_.grid(), known_}; }
  [[nodiscard]] const navigation::OccupancyMap& truth() const { return truth_; }

 private:
  navigation::OccupancyMap truth_;
  double range_m_;
  std::vector<navigation::Cell> known_;
};

}  // namespace tocsin::exploration
