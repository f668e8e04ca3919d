// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::navigation {

enum class Cell : std::uint8_t { free, occupied, unknown };

/// Column and row of a cell; (0, 0) is the cell at the map's origin, rows grow with y.
struct CellIndex {
  int column = 0;
  int row = 0;
};

/// Size and place of a grid: `origin` is the lower left corner of cell (0, 0).
struct Grid {
  int width = 0;
  int height = 0;
  double resolution_m = 0.05;
  geometry::Point origin;

  [[nodiscard]] bool contains(CellIndex c) const {
    return c.column >= 0 && c.row >= 0 && c.column < width && c.row < height;
  }
  [[nodiscard]] std::size_t offset(CellIndex c) const {
    return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(c.column);
  }
  [[nodiscard]] std::size_t size() const { return offset({0, height}); }
  /// The cell that holds `p`, empty outside the grid or when `p` is not finite.
  [[nodiscard]] std::optional<CellIndex> cell_of(const geometry::Point& p) const;
  [[nodiscard]] geometry::Point centre(CellIndex c) const;
};

/// What is known of a floor, cell by cell. Immutable, so any thread may read it, and copies share.
class OccupancyMap {
 public:
  /// `cells` row by row from the origin up. Asserts that there are width x height of them.
  OccupancyMap(const Grid& grid, std::vector<Cell> cells);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] Cell at(CellIndex c) const { return content_->cells[grid_.offset(c)]; }
  /// Row by row from the origin up.
  [[nodiscard]] const std::vector<Cell>& cells() const { return content_->cells; }
  /// Outside the map everything is unknown.
  [[nodiscard]] Cell at(const geometry::Point& p) const;

  /// Distance to the first occupied cell [m], seen from `from` in direction `bearing_rad`.
  /// Empty when there is none within `range_m`; unknown cells do not stop the ray.
  [[nodiscard]] std::optional<double> raycast(const geometry::Point& from, double bearing_rad,
                                              double range_m) const;

  /// Whether a disc of radius `radius_m` at (x, y) touches an occupied cell.
  [[nodiscard]] bool collides(double x, double y, double radius_m) const;
  /// Whether no disc that lies within `reach_m` of (x, y) touches an occupied cell, which takes no
  /// longer to tell than `collides` of one. False may be wrong: a square is looked at.
  [[nodiscard]] bool is_clear(double x, double y, double reach_m) const;

 private:
  /// Cells from `low` up to and including `high`, both on the map.
  struct Window {
    CellIndex low;
    CellIndex high;
  };
  /// All cells that touch the disc; none when (x, y) is not finite.
  [[nodiscard]] Window window_around(double x, double y, double radius_m) const;
  [[nodiscard]] bool may_have_occupied(const Window& window) const;

  struct Content {
    std::vector<Cell> cells;
    /// For each corner of a cell: how many cells left of it and below it are occupied, modulo
    /// 65536, so that four numbers tell how many are in a rectangle of fewer cells.
    std::vector<std::uint16_t> occupied;
  };
  [[nodiscard]] static std::vector<std::uint16_t> count_occupied(const Grid& grid,
                                                                 const std::vector<Cell>& cells);
  Grid grid_;
  std::shared_ptr<const Content> content_;
};

}  // namespace tocsin::navigation
