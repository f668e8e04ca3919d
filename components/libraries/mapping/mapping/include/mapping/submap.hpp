// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "laser_geometry/scan.hpp"
#include "mapping/likelihood_field.hpp"
#include "mapping/occupancy_grid.hpp"

namespace tocsin::mapping {

/// How far points agree with what a submap has seen.
struct Agreement {
  double seen = 0;  ///< share of the points that lie where the submap knows something [range 0,1]
  double opposed = 0;  ///< share of those that lie where it has seen that nothing is [range 0,1]
};

/// A piece of the map that is small enough to have no drift, in the frame of its first node. It
/// grows until it is finished. Not thread-safe, not even when it is const.
class Submap {
 public:
  Submap(std::size_t first_node, double resolution_m, double sigma_m);

  /// Adds the scan of `node`, taken at `pose` in the frame of the submap.
  void insert(std::size_t node, const Scan& scan, const geometry::Pose& pose);
  /// Keeps the points that are still there (people have gone), and gives back the memory that
  /// growing needs.
  void finish();

  /// Makes a finished submap anew of the same scans at other poses.
  void rebuild(const std::vector<Scan>& scans, const std::vector<geometry::Pose>& poses);

  [[nodiscard]] bool is_finished() const { return finished_; }
  [[nodiscard]] std::size_t first_node() const { return first_node_; }
  /// Nodes that are inserted, the first one among them, and their poses in the submap's frame.
  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<geometry::Pose>& poses() const { return poses_; }
  [[nodiscard]] bool contains(std::size_t node) const;
  /// Made when it is asked for, of a finished one.
  [[nodiscard]] const LikelihoodField& field() const;
  /// For searches; made when it is asked for after an insertion.
  [[nodiscard]] const FieldBounds& bounds() const;
  /// Gives back the memory of a finished one's field and bounds until they are asked for.
  void rest() const;
  [[nodiscard]] bool is_resting() const { return !field_; }
  /// Asserts that it is finished.
  [[nodiscard]] Agreement agreement(const Points& points, const geometry::Pose& pose) const;

 private:
  /// A quarter of a cell, as fine as a field tells points apart; counted from the frame's origin.
  struct Place {
    int x = 0;
    int y = 0;
    bool operator<(const Place& o) const { return x != o.x ? x < o.x : y < o.y; }
    bool operator==(const Place& o) const { return x == o.x && y == o.y; }
  };
  void keep_places();
  void keep_free_cells();
  [[nodiscard]] bool is_free(const geometry::Point& p) const;
  std::size_t first_node_;
  double resolution_m_;
  double sigma_m_;
  bool finished_ = false;
  std::vector<std::size_t> nodes_;
  std::vector<geometry::Pose> poses_;
  Points points_;              // all hits; empty when finished
  OccupancyGrid occupancy_;    // empty when finished: a bit a cell is left of it,
  std::vector<Place> places_;  // and the points, each once
  navigation::Grid free_grid_;
  std::vector<bool> free_;
  mutable std::unique_ptr<LikelihoodField> field_;
  mutable std::unique_ptr<FieldBounds> bounds_;
};

}  // namespace tocsin::mapping
