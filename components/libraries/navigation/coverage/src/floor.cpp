// SPDX-License-Identifier: Apache-2.0
#include "coverage/floor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coverage/polygon.hpp"
#include "foundation/error.hpp"
#include "navigation/distance_field.hpp"

namespace tocsin::coverage {

using geometry::Point;
using navigation::Cell;
using navigation::CellIndex;
using navigation::Grid;

std::size_t Mask::count() const {
  return static_cast<std::size_t>(std::count(cells.begin(), cells.end(), std::uint8_t{1}));
}

double Mask::area_m2() const {
  return static_cast<double>(count()) * grid.resolution_m * grid.resolution_m;
}

std::vector<Point> Mask::points() const {
  std::vector<Point> points;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      if (cells[grid.offset({column, row})] != 0) points.push_back(grid.centre({column, row}));
    }
  }
  return points;
}

Stamp::Stamp(const Grid& grid, double radius_m) : grid_(grid) {
  const double cells = radius_m / grid.resolution_m + 1e-6;
  const int reach = static_cast<int>(cells);
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      if (std::hypot(column, row) <= cells) steps_.push_back({column, row});
    }
  }
}

namespace {

void require_start(const Grid& grid, const Point& start) {
  if (!is_finite(start)) {
    throw ConfigError(fmt::format("start: ({}, {}) is not finite", start.x_m, start.y_m));
  }
  if (grid.cell_of(start)) return;
  const Point end = grid.centre({grid.width - 1, grid.height - 1});
  throw ConfigError(
      fmt::format("start: ({:g}, {:g}) is outside of the map, x [{:g}, {:g}], y [{:g}, {:g}]",
                  start.x_m, start.y_m, grid.origin.x_m, end.x_m, grid.origin.y_m, end.y_m));
}

void require_on_map(const Grid& grid, const std::vector<Point>& polygon) {
  const Point end = grid.centre({grid.width, grid.height});
  const auto all = [&](const auto& is_beyond) {
    return std::all_of(polygon.begin(), polygon.end(), is_beyond);
  };
  if (all([&](const Point& p) { return p.x_m < grid.origin.x_m; }) ||
      all([&](const Point& p) { return p.y_m < grid.origin.y_m; }) ||
      all([&](const Point& p) { return p.x_m > end.x_m; }) ||
      all([&](const Point& p) { return p.y_m > end.y_m; })) {
    throw ConfigError(fmt::format("polygon: is outside of the map, x [{:g}, {:g}], y [{:g}, {:g}]",
                                  grid.origin.x_m, end.x_m, grid.origin.y_m, end.y_m));
  }
}

/// Cells of the map that are free and, if there is one, in the polygon.
Mask free_within(const navigation::OccupancyMap& map, const std::vector<Point>& polygon) {
  Mask mask(map.grid());
  for (std::size_t i = 0; i < mask.cells.size(); ++i) mask.cells[i] = map.cells()[i] == Cell::free;
  if (polygon.empty()) return mask;
  for (int row = 0; row < mask.grid.height; ++row) {
    for (int column = 0; column < mask.grid.width; ++column) {
      const CellIndex c{column, row};
      auto& cell = mask.cells[mask.grid.offset(c)];
      cell = cell != 0 && is_inside(polygon, mask.grid.centre(c));
    }
  }
  return mask;
}

}  // namespace

Mask reached_from(const Mask& centres, const Mask& within, double width_m) {
  Mask reached(centres.grid);
  const Stamp tool(centres.grid, width_m / 2);
  for (int row = 0; row < centres.grid.height; ++row) {
    for (int column = 0; column < centres.grid.width; ++column) {
      const CellIndex c{column, row};
      if (centres.cells[centres.grid.offset(c)] == 0) continue;
      tool.at(c, [&](std::size_t offset) { reached.cells[offset] = within.cells[offset]; });
    }
  }
  return reached;
}

Floor reachable_floor(const navigation::OccupancyMap& map, const navigation::CostMap& costs,
                      const Area& area, double width_m) {
  require_start(map.grid(), area.start);
  if (!area.polygon.empty()) {
    require_polygon(area.polygon, "polygon");
    require_on_map(map.grid(), area.polygon);
  }
  const navigation::DistanceField field(costs, area.start);
  const Mask within = free_within(map, area.polygon);
  Mask centres(map.grid());
  bool reaches_any = false;
  for (std::size_t i = 0; i < centres.cells.size(); ++i) {
    reaches_any = reaches_any || field.reaches(i);
    centres.cells[i] = within.cells[i] != 0 && field.reaches(i);
  }
  if (!reaches_any) {
    throw ConfigError(fmt::format(
        "start: ({:g}, {:g}) is in a wall, on unknown floor, or too near to a wall for the robot",
        area.start.x_m, area.start.y_m));
  }
  if (centres.count() == 0) {
    throw ConfigError("polygon: the robot reaches no free floor in it from the start");
  }
  Mask floor = reached_from(centres, within, width_m);
  return {std::move(centres), std::move(floor)};
}

}  // namespace tocsin::coverage
