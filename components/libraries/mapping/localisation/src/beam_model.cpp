// SPDX-License-Identifier: Apache-2.0
#include "localisation/beam_model.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/some_of.hpp"

namespace tocsin::localisation {
namespace {

constexpr double wall_m = 0.12;    // a hit so near to a wall is of the wall
constexpr double exact_m = 0.04;   // a hit so near to it could not be better,
constexpr double early_m = 0.2;    // and one so far from it is of something else
constexpr double through_m = 0.3;  // so far behind a wall no beam ends

// Logarithms of what a beam says of a pose.
constexpr double ends_at_wall = -0.3;
constexpr double ends_early = -1.9;
constexpr double goes_through = -3.9;

double beside_wall(double away_m) {
  const double off = std::max(0.0, away_m - exact_m) / (early_m - exact_m);
  return ends_at_wall + (ends_early - ends_at_wall) * std::min(1.0, off);
}

}  // namespace

Evidence BeamModel::evidence_of(const laser::Scan& scan, const geometry::Pose& pose) const {
  const geometry::Point laser = laser::transformed({scan.laser}, pose).front();
  const laser::Points hits = laser::transformed(some_of(scan.hits, asked_beams), pose);
  Evidence evidence;
  for (const geometry::Point& hit : hits) {
    const double away_m = distances_.sample(hit).distance_m;
    evidence.explained += away_m < wall_m ? 1 : 0;
    if (away_m < early_m) {
      evidence.log_likelihood += beside_wall(away_m);
      continue;
    }
    const bool is_through =
        meets_wall(laser, bearing(laser, hit), distance(laser, hit) - through_m);
    evidence.through += is_through ? 1 : 0;
    evidence.log_likelihood += is_through ? goes_through : ends_early;
  }
  const auto count = static_cast<double>(hits.size());
  return {evidence.explained / count, evidence.through / count, evidence.log_likelihood / count};
}

/// Where nothing is near, it steps as far as that is sure (sphere tracing, Hart 1996).
bool BeamModel::meets_wall(const geometry::Point& from, double bearing_rad, double until_m) const {
  const double cell_m = distances_.grid().resolution_m;
  const double c = std::cos(bearing_rad);
  const double s = std::sin(bearing_rad);
  for (double at_m = 0; at_m < until_m;) {
    const geometry::Point here{from.x_m + at_m * c, from.y_m + at_m * s};
    if (!distances_.grid().cell_of(here)) return false;
    const double sure_m = distances_.nearest_m(here) - 1.5 * cell_m;  // of middles of two cells
    if (sure_m < cell_m) return map_.raycast(here, bearing_rad, until_m - at_m).has_value();
    at_m += sure_m;
  }
  return false;
}

double BeamModel::explained(const laser::Points& hits, const geometry::Pose& pose) const {
  const laser::Points placed = laser::transformed(hits, pose);
  const auto at_walls = std::count_if(placed.begin(), placed.end(), [this](const auto& hit) {
    return distances_.nearest_m(hit) < wall_m;
  });
  return static_cast<double>(at_walls) / static_cast<double>(hits.size());
}

}  // namespace tocsin::localisation
