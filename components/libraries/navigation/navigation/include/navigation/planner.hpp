// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "geometry/pose.hpp"
#include "navigation/cost_map.hpp"

namespace tocsin::navigation {

/// The cheapest path over a cost map: A* over eight neighbours with the octile distance, then
/// straightened wherever the straight line costs no more. The same request gives the same path.
///
/// A start that is blocked (the robot stands too near to a wall) is first left for the nearest
/// free cell within 0.5 m; a goal, within 0.15 m. The path begins at `start` itself.
///
/// Keeps the memory of its search, 5 bytes for each cell, from one plan to the next.
class Planner {
 public:
  explicit Planner(std::shared_ptr<const CostMap> map);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  /// Empty when there is no path, or a point is outside the map or not finite.
  [[nodiscard]] std::optional<geometry::Path> plan(const geometry::Point& start,
                                                   const geometry::Point& goal);

 private:
  class Search;
  std::shared_ptr<const CostMap> map_;
  std::unique_ptr<Search> search_;
};

/// Length of a path [m].
[[nodiscard]] double length_m(const geometry::Path& path);

}  // namespace tocsin::navigation
