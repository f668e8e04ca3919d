// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/distance_map.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::localisation {

/// Looks for the poses from which a scan may have been seen: every free cell of a lattice of 0.2 m,
/// in 60 headings, is tried with 40 hits. In parts, since the whole takes 1 us for each 5 cm2 of
/// free floor.
class GlobalSearch {
 public:
  static constexpr int headings = 60;

  /// Both must outlive it.
  GlobalSearch(const navigation::OccupancyMap& map, const DistanceMap& distances)
      : map_(map), distances_(distances) {}

  /// Begins with a scan; what was looked for before is forgotten.
  void begin(laser::Points hits);
  void end() { next_ = headings; }
  [[nodiscard]] bool is_running() const { return next_ < headings; }
  /// Tries so many headings more.
  void work(int count);
  /// The best of each neighbourhood (0.5 m, 20 degrees), best first, at most `most`.
  [[nodiscard]] std::vector<geometry::Pose> best(std::size_t most);

 private:
  struct Candidate {
    geometry::Pose pose;
    float score = 0;
  };
  void try_heading(double heading_rad);
  const navigation::OccupancyMap& map_;
  const DistanceMap& distances_;
  laser::Points hits_;
  std::vector<Candidate> candidates_;
  float best_score_ = 0;
  int next_ = headings;
};

}  // namespace tocsin::localisation
