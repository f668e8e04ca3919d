// SPDX-License-Identifier: Apache-2.0
#include "link_map/link_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "foundation/some_of.hpp"

namespace tocsin::link_map {
namespace {

struct Span {
  double from_m = 0;
  int cells = 0;
};

/// In whole cells, so that a map that grows keeps its squares.
Span span_of(double low_m, double high_m) {
  const double middle_m = (low_m + high_m) / 2;
  const double half_m =
      std::min((high_m - low_m) / 2 + LinkGrid::around_m, LinkGrid::most_side_m / 2);
  const double from_m = std::floor((middle_m - half_m) / LinkGrid::cell_m) * LinkGrid::cell_m;
  return {from_m, static_cast<int>(std::ceil((middle_m + half_m - from_m) / LinkGrid::cell_m))};
}

}  // namespace

std::int8_t cell_of(const Prediction& prediction) {
  constexpr double best_dbm = -30;
  constexpr double span_db = 60;
  if (!(prediction.deviation_db <= LinkGrid::known_db)) return -1;
  const double share = std::clamp((best_dbm - prediction.mean_dbm) / span_db, 0.0, 1.0);
  return static_cast<std::int8_t>(std::lround(100 * share));
}

LinkGrid grid_of(const LinkMap& map, const LossCurve& curve, const std::vector<Place>& places) {
  assert(!places.empty());
  geometry::Point low = places.front().at;
  geometry::Point high = low;
  for (const Place& place : places) {
    low = {std::min(low.x_m, place.at.x_m), std::min(low.y_m, place.at.y_m)};
    high = {std::max(high.x_m, place.at.x_m), std::max(high.y_m, place.at.y_m)};
  }
  const Span columns = span_of(low.x_m, high.x_m);
  const Span rows = span_of(low.y_m, high.y_m);
  LinkGrid grid{{columns.from_m, rows.from_m}, columns.cells, rows.cells, {}, {}};
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const geometry::Point middle{grid.origin.x_m + (column + 0.5) * LinkGrid::cell_m,
                                   grid.origin.y_m + (row + 0.5) * LinkGrid::cell_m};
      const Prediction prediction = map.predict(middle);
      grid.cells.push_back(cell_of(prediction));
      grid.risk.push_back(static_cast<std::int8_t>(std::lround(100 * risk(curve, prediction))));
    }
  }
  return grid;
}

LinkGrid grid_of(const Survey& survey) {
  constexpr std::size_t most_places = 300;
  const auto places = some_of(survey.places(), most_places);
  return grid_of(LinkMap(places), fit_loss_curve(survey.readings()), places);
}

}  // namespace tocsin::link_map
