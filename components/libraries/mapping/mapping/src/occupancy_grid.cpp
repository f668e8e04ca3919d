// SPDX-License-Identifier: Apache-2.0
#include "mapping/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace tocsin::mapping {
namespace {

using geometry::Point;
using navigation::Cell;
using navigation::CellIndex;
using navigation::Grid;

/// Cells by which a grid that must grow grows more than it must.
constexpr int spare_cells = 64;

struct Bounds {
  CellIndex low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  CellIndex high{std::numeric_limits<int>::min(), std::numeric_limits<int>::min()};
  void cover(CellIndex c) {
    low = {std::min(low.column, c.column), std::min(low.row, c.row)};
    high = {std::max(high.column, c.column), std::max(high.row, c.row)};
  }
};

Grid part_of(const Grid& grid, const Bounds& bounds) {
  Grid part = grid;
  part.width = bounds.high.column - bounds.low.column + 1;
  part.height = bounds.high.row - bounds.low.row + 1;
  part.origin = {grid.origin.x_m + bounds.low.column * grid.resolution_m,
                 grid.origin.y_m + bounds.low.row * grid.resolution_m};
  return part;
}

}  // namespace

OccupancyGrid::OccupancyGrid(double resolution_m, const OccupancyParams& params) : params_(params) {
  grid_.resolution_m = resolution_m;
}

CellIndex OccupancyGrid::cell(const Point& p) const {
  return {static_cast<int>(std::floor((p.x_m - grid_.origin.x_m) / grid_.resolution_m)),
          static_cast<int>(std::floor((p.y_m - grid_.origin.y_m) / grid_.resolution_m))};
}

Cell OccupancyGrid::kind(const GridCell& cell) const {
  if (cell.log_odds > params_.occupied) return Cell::occupied;
  return cell.log_odds < params_.free ? Cell::free : Cell::unknown;
}

Cell OccupancyGrid::at(const Point& p) const {
  const auto c = grid_.cell_of(p);
  return c ? at_cell(*c) : Cell::unknown;
}

int OccupancyGrid::log_odds(const Point& p) const {
  const auto c = grid_.cell_of(p);
  return c ? cells_[grid_.offset(*c)].log_odds : 0;
}

void OccupancyGrid::cover(const Points& points) {
  Bounds bounds;
  if (!cells_.empty()) {
    bounds.cover({0, 0});
    bounds.cover({grid_.width - 1, grid_.height - 1});
  }
  const Bounds before = bounds;
  for (const Point& p : points) bounds.cover(cell(p));
  if (bounds.low.column < before.low.column) bounds.low.column -= spare_cells;
  if (bounds.low.row < before.low.row) bounds.low.row -= spare_cells;
  if (bounds.high.column > before.high.column) bounds.high.column += spare_cells;
  if (bounds.high.row > before.high.row) bounds.high.row += spare_cells;
  const Grid grown = part_of(grid_, bounds);
  if (grown.width == grid_.width && grown.height == grid_.height) return;
  std::vector<GridCell> cells(grown.size());
  for (int row = 0; row < grid_.height; ++row) {
    const auto first = cells_.begin() + static_cast<std::ptrdiff_t>(grid_.offset({0, row}));
    std::copy(first, first + grid_.width,
              cells.begin() + static_cast<std::ptrdiff_t>(
                                  grown.offset({-bounds.low.column, row - bounds.low.row})));
  }
  cells_ = std::move(cells);
  grid_ = grown;
}

void OccupancyGrid::begin_scan() {
  if (++scan_ != 0) return;
  for (GridCell& cell : cells_) cell.scan = 0;
  scan_ = 1;
}

void OccupancyGrid::add(CellIndex c, int log_odds) {
  GridCell& cell = cells_[grid_.offset(c)];
  if (cell.scan == scan_) return;
  cell.scan = scan_;
  cell.log_odds = static_cast<std::int16_t>(
      std::clamp(cell.log_odds + log_odds, -params_.limit, params_.limit));
}

void OccupancyGrid::pass(const Point& from, const Point& to) {
  // Bresenham's line between the two cells.
  CellIndex c = cell(from);
  const CellIndex end = cell(to);
  const int columns = std::abs(end.column - c.column);
  const int rows = std::abs(end.row - c.row);
  const int column_step = end.column > c.column ? 1 : -1;
  const int row_step = end.row > c.row ? 1 : -1;
  int error = columns - rows;
  while (c.column != end.column || c.row != end.row) {
    add(c, params_.pass);
    const int twice = 2 * error;
    if (twice > -rows) {
      error -= rows;
      c.column += column_step;
    }
    if (twice < columns) {
      error += columns;
      c.row += row_step;
    }
  }
}

void OccupancyGrid::insert(const Scan& scan, const geometry::Pose& pose) {
  const Points hits = laser::transformed(scan.hits, pose);
  const Points open = laser::transformed(scan.open, pose);
  const Point laser = laser::transformed({scan.laser}, pose).front();
  Points all = hits;
  all.insert(all.end(), open.begin(), open.end());
  all.push_back(laser);
  cover(all);
  begin_scan();
  for (const Point& hit : hits) add(cell(hit), params_.hit);
  for (const Point& hit : hits) pass(laser, hit);
  for (const Point& end : open) pass(laser, end);
}

navigation::OccupancyMap OccupancyGrid::map() const {
  Bounds known;
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      if (kind(cells_[grid_.offset({column, row})]) != Cell::unknown) known.cover({column, row});
    }
  }
  if (known.low.column > known.high.column) {
    return {Grid{1, 1, grid_.resolution_m, grid_.origin}, {Cell::unknown}};
  }
  known.low = {known.low.column - 1, known.low.row - 1};
  known.high = {known.high.column + 1, known.high.row + 1};
  const Grid part = part_of(grid_, known);
  std::vector<Cell> cells(part.size(), Cell::unknown);
  for (int row = std::max(0, known.low.row); row < std::min(grid_.height, known.high.row); ++row) {
    for (int column = std::max(0, known.low.column);
         column < std::min(grid_.width, known.high.column); ++column) {
      cells[part.offset({column - known.low.column, row - known.low.row})] =
          kind(cells_[grid_.offset({column, row})]);
    }
  }
  return {part, std::move(cells)};
}

}  // namespace tocsin::mapping
