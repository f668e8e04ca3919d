// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/pose.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::navigation {

/// The chance that the link is lost, by place, on a grid that may be coarser than the floor's.
/// Immutable.
class LinkRisk {
 public:
  /// `percent` row by row from the origin up; what is none of [0,100] counts as 50. Asserts that
  /// there are width x height of them, and at least one.
  LinkRisk(const Grid& grid, std::vector<std::int8_t> percent);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// [range 0,1]; outside of the grid as at its rim. Asserts that `p` is finite.
  [[nodiscard]] double at(const geometry::Point& p) const;
  /// The same in the middle of each cell of another grid, row by row from the origin up.
  [[nodiscard]] std::vector<float> on(const Grid& grid) const;
  /// Short pieces of a path in turn: to `visit(risk, length_m)`, until that is false.
  template <class Visit>
  void walk(const geometry::Path& path, Visit visit) const {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const double length_m = distance(path[i - 1], path[i]);
      const int pieces =
          std::max(1, static_cast<int>(std::ceil(2 * length_m / grid_.resolution_m)));
      for (int k = 0; k < pieces; ++k) {
        const geometry::Point middle = between(path[i - 1], path[i], (k + 0.5) / pieces);
        if (!visit(at(middle), length_m / pieces)) return;
      }
    }
  }
  /// The metres of a path on which the link is expected to be lost; by speed, the seconds.
  [[nodiscard]] double silent_m(const geometry::Path& path) const;

 private:
  Grid grid_;
  std::vector<double> risk_;
};

}  // namespace tocsin::navigation
