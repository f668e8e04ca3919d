// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pose.hpp"
#include "link_map/link_map.hpp"
#include "link_map/loss_curve.hpp"
#include "link_map/survey.hpp"

namespace tocsin::link_map {

/// A map of the link in squares, as `link_map` and `link_risk` have it.
struct LinkGrid {
  static constexpr double cell_m = 0.5;
  static constexpr double around_m = 4;       ///< of the places, that is told
  static constexpr double most_side_m = 100;  ///< of more, the part around the middle
  static constexpr double known_db = 8;       ///< a greater deviation is "not known"

  geometry::Point origin;  ///< lower left corner [m]
  int width = 0;
  int height = 0;
  std::vector<std::int8_t> cells;  ///< signal, row by row from the origin up
  std::vector<std::int8_t> risk;   ///< [%] that the link is lost there, the same
};

/// 0 at -30 dBm and above, 100 at -90 dBm and below; -1 where it is not known.
[[nodiscard]] std::int8_t cell_of(const Prediction& prediction);

/// Around the places, of which there is at least one.
[[nodiscard]] LinkGrid grid_of(const LinkMap& map, const LossCurve& curve,
                               const std::vector<Place>& places);
/// The same of what was measured, at least at `LinkMap::least_places` places; of many, 300 evenly
/// chosen ones, which take a tenth of a second.
[[nodiscard]] LinkGrid grid_of(const Survey& survey);

}  // namespace tocsin::link_map
