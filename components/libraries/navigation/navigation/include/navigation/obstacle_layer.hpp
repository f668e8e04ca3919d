// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {

/// What of a scan is an obstacle, and for how long.
struct ObstacleParams {
  double obstacle_range_m = 3.5;
  double map_gap_m = 0.15;
  double forget_after_s = 30;
  double remember_touch_s = 120;
  template <class Visitor>
  void visit(Visitor& v) {
    v("obstacle_range_m", obstacle_range_m, {0.5, 10}, "[m] nearer hits become obstacles");
    v("map_gap_m", map_gap_m, {0, 1}, "[m] hits so near to a wall of the map are the wall");
    v("forget_after_s", forget_after_s, {1, 3600}, "[s] an obstacle lasts where no beam looks");
    v("remember_touch_s", remember_touch_s, {0, 86400},
      "[s] what was bumped into and no beam meets lasts");
  }
};

/// Cells of a map in which a laser sees what the map has not. Marked by hits, cleared by sight
/// (two turns in a row whose beams pass through), and by age where no beam looks. What was touched
/// where no beam meets anything, as a pane of glass or a sill, stays for its time though beams
/// pass.
///
/// Pure; `now` must not decrease. The same calls give the same cells in the same order.
class ObstacleLayer {
 public:
  ObstacleLayer(OccupancyMap map, const ObstacleParams& params);

  /// Another map, on whose free cells the marks stay where they are.
  void set_map(OccupancyMap map);
  /// A turn of the laser, seen by a vehicle at `pose` on the map.
  void on_scan(const laser::Scan& scan, const geometry::Pose& pose, Time now);
  /// Something was touched there, or the floor ends.
  void on_touch(const geometry::Point& at, Time now);
  /// Forgets all marks, those of touches, too.
  void clear_all();
  /// Drops what is too old.
  void forget(Time now);

  /// By offset in the grid.
  [[nodiscard]] std::vector<CellIndex> cells() const;
  /// Those that a vehicle at `from` has to reckon with when there is no way else: without what it
  /// has met farther away than 2 m for less than 10 s, which may walk.
  [[nodiscard]] std::vector<CellIndex> lasting_cells(const geometry::Point& from, Time now) const;
  /// Differs whenever `cells` does.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Whether the middle of an obstacle's cell lies within `radius_m` of the place.
  [[nodiscard]] bool touches(const geometry::Point& at, double radius_m) const;
  /// From the place to the middle of the nearest such cell [m]; `most_m` when there is none nearer.
  [[nodiscard]] double distance_m(const geometry::Point& at, double most_m) const;

 private:
  static constexpr std::size_t bins = 720;
  using Reach = std::array<double, bins>;  ///< of the beams [m] by bearing; 0: none looks there
  struct Mark {
    Time since;
    Time seen;
    Time kept_until = Time::min();
    int passed = 0;  ///< turns in a row whose beams have passed through
  };
  void mark(const geometry::Point& hit, Time now);
  /// Whether a beam has met an obstacle there lately.
  [[nodiscard]] bool sees_near(const geometry::Point& at, Time now) const;
  void clear(const geometry::Point& from, const Reach& reach, Time now);
  [[nodiscard]] CellIndex cell_at(std::size_t offset) const;
  void erase(std::map<std::size_t, Mark>::iterator at);

  OccupancyMap map_;
  ObstacleParams params_;
  std::map<std::size_t, Mark> marks_;
  std::vector<std::uint8_t> is_marked_;
  std::uint64_t version_ = 0;
};

}  // namespace tocsin::navigation
