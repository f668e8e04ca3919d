// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {

/// How far a planned path keeps from walls.
struct InflationParams {
  double robot_radius_m = 0.18;  // TurtleBot 2: 0.351 m diameter
  double margin_m = 0.07;
  double soft_radius_m = 0.6;
  double soft_weight = 3.0;
  template <class Visitor>
  void visit(Visitor& v) {
    v("robot_radius_m", robot_radius_m, {0.05, 1}, "[m] radius of the robot");
    v("margin_m", margin_m, {0, 1}, "[m] kept between the robot and a wall");
    v("soft_radius_m", soft_radius_m, {0, 3}, "[m] nearer to a wall costs more");
    v("soft_weight", soft_weight, {0, 50}, "[1] extra cost of a cell at a wall");
  }
  friend bool operator==(const InflationParams& a, const InflationParams& b) {
    return a.robot_radius_m == b.robot_radius_m && a.margin_m == b.margin_m &&
           a.soft_radius_m == b.soft_radius_m && a.soft_weight == b.soft_weight;
  }
};

/// What it costs to cross each cell: walls and what lies within the robot's radius and margin of
/// one are blocked, then the cost falls with the square of the distance to `soft_radius_m`.
/// Unknown cells and the outermost cells of the map are blocked, too.
class CostMap {
 public:
  /// Cost of a cell far from walls; 0 is blocked.
  static constexpr std::uint16_t plain = 10;
  /// No cell that is not blocked costs more.
  static constexpr std::uint16_t dearest = 51 * plain;

  CostMap(const OccupancyMap& map, const InflationParams& params);
  /// The costs of `base`, and of obstacles in these of its cells as if they were walls.
  CostMap(const CostMap& base, const std::vector<CellIndex>& obstacles,
          const InflationParams& params);
  /// The costs of `base`, each dearer by `weight` times the share that it has of `shares`, as far
  /// as `dearest` allows. Asserts that there is one for each cell.
  CostMap(const CostMap& base, const std::vector<float>& shares, double weight);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] std::uint16_t cost(std::size_t offset) const { return costs_[offset]; }
  [[nodiscard]] bool blocked(CellIndex c) const {
    return !grid_.contains(c) || costs_[grid_.offset(c)] == 0;
  }
  [[nodiscard]] bool blocked(const geometry::Point& p) const;
  /// The cell of `p`; when that is blocked, the nearest one within `reach_m` that is not.
  [[nodiscard]] std::optional<CellIndex> nearest_free(const geometry::Point& p,
                                                      double reach_m) const;

 private:
  struct DiscRow;
  [[nodiscard]] static std::vector<DiscRow> disc_of(double resolution_m,
                                                    const InflationParams& params);
  /// A cell is as dear as the dearest that was asked of it; 0, blocked, is the dearest of all.
  void raise(CellIndex wall, const DiscRow& disc);
  Grid grid_;
  std::vector<std::uint16_t> costs_;
};

}  // namespace tocsin::navigation
