// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "laser_geometry/scan.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::mapping {

using laser::Points;
using laser::Scan;

/// How likely a beam ends at a place: exp(-d^2 / (2 sigma^2)) of the distance d to the nearest
/// point that was stamped, in steps of 1/255. Points are kept to a quarter of a cell.
class LikelihoodField {
 public:
  struct Sample {
    double value = 0;          ///< [range 0,1]
    double slope_x_per_m = 0;  ///< derivatives of the interpolated value
    double slope_y_per_m = 0;
  };

  static constexpr int places = 4;  ///< of a point within its cell, along each axis

  LikelihoodField(double resolution_m, double sigma_m);

  /// Adds points, given in the frame of the field.
  void stamp(const Points& points);

  [[nodiscard]] double sigma_m() const { return sigma_m_; }
  [[nodiscard]] const navigation::Grid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return cells_; }
  /// Bilinear between the centres of cells; 0 outside.
  [[nodiscard]] Sample at(double x_m, double y_m) const;

  /// Second derivatives [1/m^2] by central differences over `sigma_m`, in whole cells.
  struct Curvature {
    double xx = 0;
    double xy = 0;
    double yy = 0;
  };
  /// Of what `at` gives; 0 where a difference would reach outside.
  [[nodiscard]] Curvature curvature_at(double x_m, double y_m) const;

 private:
  void cover(const Points& points);
  void stamp(const geometry::Point& p);
  /// A place as at() sees it: the cell whose centre is left of and below it, and how far it is from
  /// there [cell, range 0,1].
  struct Between {
    int column;
    int row;
    double u;
    double v;
  };
  /// Empty when fewer than `border` cells of the field lie around it.
  [[nodiscard]] std::optional<Between> between(double x_m, double y_m, int border) const;

  double sigma_m_;
  navigation::Grid grid_;
  int reach_;  // cells from the centre of a kernel to its border
  /// One kernel for each place of a point within its cell, row by row.
  std::vector<std::vector<std::uint8_t>> kernels_;
  std::vector<std::uint8_t> cells_;
};

/// Bounds of a field for branch and bound: level h holds for each square of 2^h cells the largest
/// value that a cell of it can reach when it is moved by 0 to 2^h - 1 cells along both axes (Hess
/// et al., ICRA 2016, kept once a square as by Olson, ICRA 2009: a third of the field's memory, not
/// one field a level).
class FieldBounds {
 public:
  static constexpr int levels = 6;

  /// The field must outlive this, unchanged.
  explicit FieldBounds(const LikelihoodField& field);
  FieldBounds(const FieldBounds&) = delete;
  FieldBounds& operator=(const FieldBounds&) = delete;

  [[nodiscard]] const navigation::Grid& grid() const { return *grid_; }
  /// Sum over `count` cells of the field, each moved by `offset`, of their bounds [range 0,255 a
  /// cell]; 0 for a cell that cannot reach the field. A smaller sum may come back when it could not
  /// have become more than `needed`.
  [[nodiscard]] int sum(int level, const navigation::CellIndex* cells, std::size_t count,
                        navigation::CellIndex offset, int needed) const;

 private:
  struct Level {
    int width = 0;
    int height = 0;
    int border = 0;  // squares left of and below the field
    const std::uint8_t* cells = nullptr;
    std::vector<std::uint8_t> own;
  };
  [[nodiscard]] static Level pooled(const Level& finer);
  [[nodiscard]] static Level widened(const Level& pool);

  const navigation::Grid* grid_;
  std::vector<Level> levels_;
};

}  // namespace tocsin::mapping
