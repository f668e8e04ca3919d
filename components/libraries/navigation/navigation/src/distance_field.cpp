// SPDX-License-Identifier: Apache-2.0
#include "navigation/distance_field.hpp"

#include "foundation/numbers.hpp"
#include "open_cells.hpp"

namespace tocsin::navigation {

DistanceField::DistanceField(const CostMap& map, const geometry::Point& start)
    : grid_(map.grid()), costs_(grid_.size(), unreached) {
  const auto from = map.nearest_free(start, start_reach_m);
  if (from) fill(map, *from);
}

/// The rim of the map is blocked, so a cell that is open has all eight neighbours.
void DistanceField::fill(const CostMap& map, CellIndex from) {
  OpenCells open;
  open.restart(0);
  costs_[grid_.offset(from)] = 0;
  open.put(0, from);
  while (!open.empty()) {
    const CellIndex cell = open.take();
    const std::size_t at = grid_.offset(cell);
    if (open.estimate() != costs_[at]) continue;  // reached cheaper meanwhile
    const std::uint32_t here = map.cost(at);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const CellIndex to = add(cell, steps[i]);
      const std::size_t offset = grid_.offset(to);
      const std::uint32_t there = map.cost(offset);
      const std::uint32_t sum = costs_[at] + (i < 4 ? straight : diagonal) * (here + there) / 2;
      if (there == 0 || sum >= costs_[offset] || (i >= 4 && cuts_corner(map, cell, to))) continue;
      costs_[offset] = sum;
      open.put(sum, to);
    }
  }
}

bool DistanceField::reaches(std::size_t offset) const { return costs_[offset] != unreached; }

double DistanceField::distance_m(std::size_t offset) const {
  if (!reaches(offset)) return infinity;
  return costs_[offset] * grid_.resolution_m / (straight * CostMap::plain);
}

double DistanceField::distance_m(const geometry::Point& p) const {
  const auto cell = grid_.cell_of(p);
  return cell ? distance_m(grid_.offset(*cell)) : infinity;
}

}  // namespace tocsin::navigation
