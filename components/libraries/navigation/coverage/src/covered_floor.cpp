// SPDX-License-Identifier: Apache-2.0
#include "coverage/covered_floor.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::coverage {

using geometry::Point;

CoveredFloor::CoveredFloor(const Mask& floor, double width_m)
    : uncovered_(floor), tool_(floor.grid, width_m / 2), all_(floor.count()), left_(all_) {}

template <class Mark>
void CoveredFloor::pass(const Point& from, const Point& to, const Mark& mark) const {
  const double step_m = uncovered_.grid.resolution_m;
  const int steps = static_cast<int>(std::ceil(distance(from, to) / step_m));
  for (int i = 0; i <= steps; ++i) {
    const auto cell =
        uncovered_.grid.cell_of(steps == 0 ? from : between(from, to, double(i) / steps));
    if (cell) tool_.at(*cell, mark);
  }
}

void CoveredFloor::drive(const Point& from, const Point& to) {
  pass(from, to, [&](std::size_t offset) {
    left_ -= uncovered_.cells[offset];
    uncovered_.cells[offset] = 0;
  });
}

void CoveredFloor::drive(const geometry::Path& path) {
  for (std::size_t i = 1; i < path.size(); ++i) drive(path[i - 1], path[i]);
}

void CoveredFloor::drive(const SwathCell& cell) {
  for (std::size_t i = 0; i < cell.size(); ++i) {
    drive(cell[i].from, cell[i].to);
    if (i + 1 == cell.size()) break;
    const bool is_there = i % 2 == 0;
    drive(is_there ? cell[i].to : cell[i].from, is_there ? cell[i + 1].to : cell[i + 1].from);
  }
}

std::size_t CoveredFloor::gain(const Swath& swath) {
  counted_.clear();
  pass(swath.from, swath.to, [&](std::size_t offset) {
    if (uncovered_.cells[offset] == 0) return;
    uncovered_.cells[offset] = 0;
    counted_.push_back(offset);
  });
  for (const std::size_t offset : counted_) uncovered_.cells[offset] = 1;
  return counted_.size();
}

double CoveredFloor::share() const {
  return all_ == 0 ? 1 : 1 - static_cast<double>(left_) / static_cast<double>(all_);
}

double CoveredFloor::uncovered_m2() const {
  const double side_m = uncovered_.grid.resolution_m;
  return static_cast<double>(left_) * side_m * side_m;
}

}  // namespace tocsin::coverage
