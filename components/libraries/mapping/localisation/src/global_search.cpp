// SPDX-License-Identifier: Apache-2.0
#include "localisation/global_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin::localisation {
namespace {

constexpr double lattice_m = 0.2;
constexpr std::size_t tried_hits = 40;
constexpr double apart_m = 0.5;
constexpr double apart_rad = 20 * degree;
constexpr double blur_m = 0.3;

/// Hits from the cell of the vehicle.
struct Offsets {
  std::vector<navigation::CellIndex> cells;
  std::vector<std::ptrdiff_t> steps;  ///< the same in a grid's row-by-row order
  navigation::CellIndex low;          ///< of the rectangle that holds them
  navigation::CellIndex high;
};

Offsets offsets_of(const laser::Points& hits, double heading_rad, const navigation::Grid& grid) {
  Offsets offsets;
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  const std::size_t step = std::max<std::size_t>(1, hits.size() / tried_hits);
  const auto cells = [&](double way_m) {
    return static_cast<int>(std::lround(way_m / grid.resolution_m));
  };
  for (std::size_t i = 0; i < hits.size(); i += step) {
    const geometry::Point& hit = hits[i];
    const navigation::CellIndex at{cells(c * hit.x_m - s * hit.y_m),
                                   cells(s * hit.x_m + c * hit.y_m)};
    offsets.cells.push_back(at);
    offsets.steps.push_back(std::ptrdiff_t{at.row} * grid.width + at.column);
    offsets.low = {std::min(offsets.low.column, at.column), std::min(offsets.low.row, at.row)};
    offsets.high = {std::max(offsets.high.column, at.column), std::max(offsets.high.row, at.row)};
  }
  return offsets;
}

float nearness(float away_m) { return std::max(0.0F, 1 - away_m / static_cast<float>(blur_m)); }

/// How near the hits are to walls, from 0 to 1 each.
float score_at(const DistanceMap& distances, const Offsets& offsets, navigation::CellIndex cell) {
  const navigation::Grid& grid = distances.grid();
  const float* const here = &distances.cells()[grid.offset(cell)];
  float score = 0;
  const bool are_inside =
      grid.contains({cell.column + offsets.low.column, cell.row + offsets.low.row}) &&
      grid.contains({cell.column + offsets.high.column, cell.row + offsets.high.row});
  if (are_inside) {
    for (const std::ptrdiff_t step : offsets.steps) score += nearness(here[step]);
    return score;
  }
  for (std::size_t i = 0; i < offsets.cells.size(); ++i) {
    const navigation::CellIndex& hit = offsets.cells[i];
    if (!grid.contains({cell.column + hit.column, cell.row + hit.row})) continue;
    score += nearness(here[offsets.steps[i]]);
  }
  return score;
}

bool is_near(const geometry::Pose& a, const geometry::Pose& b) {
  return distance(position(a), position(b)) < apart_m &&
         std::abs(geometry::wrap_angle(a.heading_rad - b.heading_rad)) < apart_rad;
}

}  // namespace

void GlobalSearch::begin(laser::Points hits) {
  hits_ = std::move(hits);
  candidates_.clear();
  best_score_ = 0;
  next_ = hits_.empty() ? headings : 0;
}

void GlobalSearch::work(int count) {
  for (const int end = std::min(headings, next_ + count); next_ < end; ++next_) {
    try_heading(geometry::wrap_angle(next_ * 2 * pi / headings));
  }
}

void GlobalSearch::try_heading(double heading_rad) {
  const navigation::Grid& grid = map_.grid();
  const int step = std::max(1, static_cast<int>(lattice_m / grid.resolution_m));
  const Offsets offsets = offsets_of(hits_, heading_rad, grid);
  for (int row = step / 2; row < grid.height; row += step) {
    for (int column = step / 2; column < grid.width; column += step) {
      const navigation::CellIndex cell{column, row};
      if (map_.at(cell) != navigation::Cell::free) continue;
      const float score = score_at(distances_, offsets, cell);
      if (score < 0.6F * best_score_) continue;
      best_score_ = std::max(best_score_, score);
      const geometry::Point at = grid.centre(cell);
      candidates_.push_back({{at.x_m, at.y_m, heading_rad}, score});
    }
  }
}

std::vector<geometry::Pose> GlobalSearch::best(std::size_t most) {
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  std::vector<geometry::Pose> best;
  for (const Candidate& candidate : candidates_) {
    const bool is_new = std::none_of(best.begin(), best.end(), [&](const geometry::Pose& pose) {
      return is_near(pose, candidate.pose);
    });
    if (is_new) best.push_back(candidate.pose);
    if (best.size() == most) break;
  }
  return best;
}

}  // namespace tocsin::localisation
