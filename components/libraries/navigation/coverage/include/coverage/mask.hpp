// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "navigation/occupancy_map.hpp"

namespace tocsin::coverage {

/// Some cells of a grid.
struct Mask {
  explicit Mask(const navigation::Grid& of) : grid(of), cells(of.size(), 0) {}

  [[nodiscard]] bool has(const geometry::Point& p) const {
    const auto cell = grid.cell_of(p);
    return cell && cells[grid.offset(*cell)] != 0;
  }
  [[nodiscard]] std::size_t count() const;
  /// [m^2]
  [[nodiscard]] double area_m2() const;
  /// Middles of the cells, row by row.
  [[nodiscard]] std::vector<geometry::Point> points() const;

  navigation::Grid grid;
  std::vector<std::uint8_t> cells;  ///< 1 or 0, row by row
};

/// The cells whose middle is not farther than a radius from a cell's middle.
class Stamp {
 public:
  Stamp(const navigation::Grid& grid, double radius_m);
  /// Calls `mark(offset)` for each that is on the grid.
  template <class Mark>
  void at(navigation::CellIndex middle, const Mark& mark) const {
    for (const navigation::CellIndex step : steps_) {
      const navigation::CellIndex c{middle.column + step.column, middle.row + step.row};
      if (grid_.contains(c)) mark(grid_.offset(c));
    }
  }

 private:
  navigation::Grid grid_;
  std::vector<navigation::CellIndex> steps_;
};

}  // namespace tocsin::coverage
