// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pose.hpp"
#include "navigation/cost_map.hpp"

namespace tocsin::navigation {

/// How far it is from one place to every cell, on the cheapest ways over a cost map (Dijkstra).
/// A start that is blocked is left for the nearest free cell within 0.5 m, as Planner does.
class DistanceField {
 public:
  /// Nothing can be reached when the start is outside of the map, not finite, or walled in.
  DistanceField(const CostMap& map, const geometry::Point& start);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] bool reaches(std::size_t offset) const;
  /// [m] on plain floor; dearer cells count as longer. Infinite where nothing leads to.
  [[nodiscard]] double distance_m(std::size_t offset) const;
  [[nodiscard]] double distance_m(const geometry::Point& p) const;

 private:
  void fill(const CostMap& map, CellIndex from);
  Grid grid_;
  std::vector<std::uint32_t> costs_;
};

}  // namespace tocsin::navigation
