// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::mapping {

using laser::Points;
using laser::Scan;

/// Log odds of a cell, in hundredths.
struct OccupancyParams {
  int hit = 85;       ///< added where a beam ends
  int pass = -20;     ///< added where a beam passes
  int limit = 350;    ///< neither more nor less than this, so that a change is seen
  int occupied = 50;  ///< more is occupied
  int free = -15;     ///< less is free, the rest is unknown
};

/// An occupancy grid in log odds that grows with what is inserted (Moravec and Elfes 1985; Thrun,
/// Burgard and Fox, Probabilistic Robotics, 9.2). One scan changes a cell once; a hit outweighs the
/// passes of the same scan.
class OccupancyGrid {
 public:
  explicit OccupancyGrid(double resolution_m, const OccupancyParams& params = {});

  /// Inserts a scan taken at `pose`, given in the frame of the grid.
  void insert(const Scan& scan, const geometry::Pose& pose);

  /// Size 0 until something is inserted.
  [[nodiscard]] const navigation::Grid& grid() const { return grid_; }
  /// Unknown outside of the grid.
  [[nodiscard]] navigation::Cell at(const geometry::Point& p) const;
  [[nodiscard]] navigation::Cell at_cell(navigation::CellIndex c) const {
    return grid_.contains(c) ? kind(cells_[grid_.offset(c)]) : navigation::Cell::unknown;
  }
  /// [hundredths] 0 where nothing is known.
  [[nodiscard]] int log_odds(const geometry::Point& p) const;
  /// What is known, cut to what is not unknown, with a border of one cell. One unknown cell when
  /// nothing is.
  [[nodiscard]] navigation::OccupancyMap map() const;

 private:
  struct GridCell {
    std::int16_t log_odds = 0;
    std::uint16_t scan = 0;  // the last one that changed it
  };
  [[nodiscard]] navigation::Cell kind(const GridCell& cell) const;
  void cover(const Points& points);
  void begin_scan();
  void add(navigation::CellIndex c, int log_odds);
  /// Adds passes from `from` up to, but without, the cell of `to`.
  void pass(const geometry::Point& from, const geometry::Point& to);
  [[nodiscard]] navigation::CellIndex cell(const geometry::Point& p) const;

  OccupancyParams params_;
  navigation::Grid grid_;
  std::vector<GridCell> cells_;
  std::uint16_t scan_ = 0;
};

}  // namespace tocsin::mapping
