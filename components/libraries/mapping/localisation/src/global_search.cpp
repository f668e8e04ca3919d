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

/// Columns and rows of hits from the cell of the vehicle.
struct Offsets {
  std::vector<int> columns;
  std::vector<int> rows;
};

Offsets offsets_of(const laser::Points& hits, double heading_rad, double resolution_m) {
  Offsets offsets;
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  const std::size_t step = std::max<std::size_t>(1, hits.size() / tried_hits);
  for (std::size_t i = 0; i < hits.size(); i += step) {
    const geometry::Point& hit = hits[i];
    offsets.columns.push_back(
        static_cast<int>(std::lround((c * hit.x_m - s * hit.y_m) / resolution_m)));
    offsets.rows.push_back(
        static_cast<int>(std::lround((s * hit.x_m + c * hit.y_m) / resolution_m)));
  }
  return offsets;
}

/// How near the hits are to walls, from 0 to 1 each.
float score_at(const DistanceMap& distances, const Offsets& offsets, navigation::CellIndex cell) {
  const navigation::Grid& grid = distances.grid();
  float score = 0;
  for (std::size_t i = 0; i < offsets.columns.size(); ++i) {
    const navigation::CellIndex at{cell.column + offsets.columns[i], cell.row + offsets.rows[i]};
    if (!grid.contains(at)) continue;
    const float away_m = distances.cells()[grid.offset(at)];
    score += std::max(0.0F, 1 - away_m / static_cast<float>(blur_m));
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
  const Offsets offsets = offsets_of(hits_, heading_rad, grid.resolution_m);
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
