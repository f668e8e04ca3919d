// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/pose.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::localisation {

/// How far it is from each place of a map to the nearest wall, up to a limit: exact between the
/// middles of cells, linear between them. Made in time that walls take, not floor.
class DistanceMap {
 public:
  static constexpr double most_m = 1.0;

  explicit DistanceMap(const navigation::OccupancyMap& map);

  struct Sample {
    double distance_m = most_m;
    double dx = 0;  ///< of the distance by x [1]
    double dy = 0;
  };
  /// Outside of the map nothing is near, and nothing slopes.
  [[nodiscard]] Sample sample(const geometry::Point& p) const;
  /// Of the cell that holds the place [m]; `most_m` outside.
  [[nodiscard]] double nearest_m(const geometry::Point& p) const;
  [[nodiscard]] const navigation::Grid& grid() const { return grid_; }
  /// Row by row from the origin up [m].
  [[nodiscard]] const std::vector<float>& cells() const { return distances_m_; }

 private:
  navigation::Grid grid_;
  std::vector<float> distances_m_;
};

}  // namespace tocsin::localisation
