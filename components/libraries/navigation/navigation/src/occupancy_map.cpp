// SPDX-License-Identifier: Apache-2.0
#include "navigation/occupancy_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace tocsin::navigation {
namespace {

/// One axis of a walk from cell to cell along a ray (Amanatides and Woo 1987).
struct Axis {
  int step;
  double next;   // ray length at the next cell border [m]
  double delta;  // ray length across one cell [m]
};

Axis axis_of(double position_in_cells, double direction, double resolution_m) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (direction == 0) return {0, infinity, infinity};
  const double floor = std::floor(position_in_cells);
  const double to_border =
      direction > 0 ? floor + 1 - position_in_cells : position_in_cells - floor;
  const double delta = resolution_m / std::abs(direction);
  return {direction > 0 ? 1 : -1, to_border * delta, delta};
}

double distance_to_interval(double value, double low, double high) {
  return std::max({low - value, 0.0, value - high});
}

}  // namespace

std::optional<CellIndex> Grid::cell_of(const geometry::Point& p) const {
  const double column = std::floor((p.x_m - origin.x_m) / resolution_m);
  const double row = std::floor((p.y_m - origin.y_m) / resolution_m);
  if (!(column >= 0 && row >= 0 && column < width && row < height)) return std::nullopt;
  return CellIndex{static_cast<int>(column), static_cast<int>(row)};
}

geometry::Point Grid::centre(CellIndex c) const {
  return {origin.x_m + (c.column + 0.5) * resolution_m, origin.y_m + (c.row + 0.5) * resolution_m};
}

OccupancyMap::OccupancyMap(const Grid& grid, std::vector<Cell> cells) : grid_(grid) {
  assert(grid_.width > 0 && grid_.height > 0 && grid_.resolution_m > 0);
  assert(cells.size() == grid_.size());
  auto occupied = count_occupied(grid, cells);
  content_ = std::make_shared<const Content>(Content{std::move(cells), std::move(occupied)});
}

std::vector<std::uint16_t> OccupancyMap::count_occupied(const Grid& grid,
                                                        const std::vector<Cell>& cells) {
  const auto width = static_cast<std::size_t>(grid.width);
  const auto height = static_cast<std::size_t>(grid.height);
  std::vector<std::uint16_t> counts((width + 1) * (height + 1), 0);
  const Cell* cell = cells.data();
  for (std::size_t row = 1; row <= height; ++row) {
    const std::uint16_t* const below = &counts[(row - 1) * (width + 1)];
    std::uint16_t* const here = &counts[row * (width + 1)];
    unsigned in_row = 0;
    for (std::size_t column = 1; column <= width; ++column) {
      in_row += *cell++ == Cell::occupied ? 1U : 0U;
      here[column] = static_cast<std::uint16_t>(below[column] + in_row);
    }
  }
  return counts;
}

Cell OccupancyMap::at(const geometry::Point& p) const {
  const auto cell = grid_.cell_of(p);
  return cell ? at(*cell) : Cell::unknown;
}

std::optional<double> OccupancyMap::raycast(const geometry::Point& from, double bearing_rad,
                                            double range_m) const {
  auto start = grid_.cell_of(from);
  if (!start || !std::isfinite(bearing_rad)) return std::nullopt;
  CellIndex cell = *start;
  Axis x = axis_of((from.x_m - grid_.origin.x_m) / grid_.resolution_m, std::cos(bearing_rad),
                   grid_.resolution_m);
  Axis y = axis_of((from.y_m - grid_.origin.y_m) / grid_.resolution_m, std::sin(bearing_rad),
                   grid_.resolution_m);
  double length_m = 0;
  while (grid_.contains(cell) && length_m <= range_m) {
    if (at(cell) == Cell::occupied) return length_m;
    Axis& nearer = x.next < y.next ? x : y;
    (x.next < y.next ? cell.column : cell.row) += nearer.step;
    length_m = nearer.next;
    nearer.next += nearer.delta;
  }
  return std::nullopt;
}

bool OccupancyMap::may_have_occupied(const Window& window) const {
  const int width = window.high.column - window.low.column + 1;
  const int height = window.high.row - window.low.row + 1;
  if (width <= 0 || height <= 0) return false;
  if (std::int64_t{width} * height > 65535) return true;
  const Grid corners{grid_.width + 1, grid_.height + 1, grid_.resolution_m, grid_.origin};
  const auto until = [&](int column, int row) -> unsigned {
    return content_->occupied[corners.offset({column, row})];
  };
  const int right = window.high.column + 1;
  const int top = window.high.row + 1;
  const unsigned count = until(right, top) - until(window.low.column, top) -
                         until(right, window.low.row) + until(window.low.column, window.low.row);
  return static_cast<std::uint16_t>(count) != 0;
}

OccupancyMap::Window OccupancyMap::window_around(double x, double y, double radius_m) const {
  if (!is_finite(geometry::Point{x, y})) return {{0, 0}, {-1, -1}};
  const double r = grid_.resolution_m;
  const double column = std::floor((x - grid_.origin.x_m) / r);
  const double row = std::floor((y - grid_.origin.y_m) / r);
  const double reach = std::ceil(radius_m / r);
  const auto clamp = [](double cell, int size) {
    return static_cast<int>(std::clamp(cell, -1.0, static_cast<double>(size)));
  };
  return {{std::max(0, clamp(column - reach, grid_.width)),
           std::max(0, clamp(row - reach, grid_.height))},
          {std::min(clamp(column + reach, grid_.width), grid_.width - 1),
           std::min(clamp(row + reach, grid_.height), grid_.height - 1)}};
}

bool OccupancyMap::is_clear(double x, double y, double reach_m) const {
  return !may_have_occupied(window_around(x, y, reach_m));
}

bool OccupancyMap::collides(double x, double y, double radius_m) const {
  const Window window = window_around(x, y, radius_m);
  if (!may_have_occupied(window)) return false;
  const double r = grid_.resolution_m;
  for (int i = window.low.row; i <= window.high.row; ++i) {
    const double dy = distance_to_interval(y - grid_.origin.y_m, i * r, (i + 1) * r);
    for (int j = window.low.column; j <= window.high.column; ++j) {
      if (at(CellIndex{j, i}) != Cell::occupied) continue;
      const double dx = distance_to_interval(x - grid_.origin.x_m, j * r, (j + 1) * r);
      if (dx * dx + dy * dy <= radius_m * radius_m) return true;
    }
  }
  return false;
}

}  // namespace tocsin::navigation
