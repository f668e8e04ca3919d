// SPDX-License-Identifier: Apache-2.0
#include "fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "foundation/numbers.hpp"
#include "wall_directions.hpp"

namespace tocsin::coverage {
namespace {

using geometry::Point;
using navigation::CellIndex;

constexpr double least_m2 = 0.01;   // of a gap, and of what a swath must add
constexpr double approach_m = 0.4;  // way to a swath, at least
constexpr std::size_t most_of_a_gap = 12;

/// The cells of `left` that hang together with `from`, taken out of it.
Mask take_gap(Mask& left, CellIndex from) {
  Mask gap(left.grid);
  std::vector<CellIndex> open{from};
  left.cells[left.grid.offset(from)] = 0;
  while (!open.empty()) {
    const CellIndex at = open.back();
    open.pop_back();
    gap.cells[left.grid.offset(at)] = 1;
    for (int i = 0; i < 9; ++i) {
      const CellIndex next{at.column + i % 3 - 1, at.row + i / 3 - 1};
      if (!left.grid.contains(next) || left.cells[left.grid.offset(next)] == 0) continue;
      left.cells[left.grid.offset(next)] = 0;
      open.push_back(next);
    }
  }
  return gap;
}

class Filling {
 public:
  Filling(const Mask& centres, const Tool& tool, double least_share, CoveredFloor& covered)
      : centres_(centres),
        tool_(tool),
        least_share_(least_share),
        covered_(covered),
        walls_(wall_directions(centres, 4)) {}

  void fill(const Mask& gap) {
    // Where the robot may be to cover some of it, and somewhat more, so that lines are not broken
    // by the steps of a slanting edge.
    const Mask passable = reached_from(gap, centres_, 2 * tool_.width_m);
    auto directions = walls_;
    directions.push_back(long_axis(gap.points()));
    directions.push_back(directions.back() + pi / 2);
    for (std::size_t i = 0; i < most_of_a_gap; ++i) {
      const auto [swath, share] = best_swath(passable, directions);
      if (share == 0) return;
      covered_.drive(swath.from, swath.to);
      swaths_.push_back({swath});
    }
  }
  [[nodiscard]] std::vector<SwathCell> take() { return std::move(swaths_); }

 private:
  /// Of all lines in these directions, the one that covers most for its way, and the share of the
  /// way that does; 0 when none is worth it.
  std::pair<Swath, double> best_swath(const Mask& passable, const std::vector<double>& directions) {
    const double cell_m = passable.grid.resolution_m;
    std::pair<Swath, double> best{{}, 0};
    const auto consider = [&](const Swath& swath) {
      const double gain_m2 = static_cast<double>(covered_.gain(swath)) * cell_m * cell_m;
      const double share = gain_m2 / (tool_.width_m * (length_m(swath) + approach_m));
      if (gain_m2 >= least_m2 && share > std::max(best.second, least_share_)) best = {swath, share};
    };
    for (const double direction : directions) {
      for (const SwathCell& cell : swath_cells(passable, {direction, cell_m, 0})) {
        std::for_each(cell.begin(), cell.end(), consider);
      }
    }
    return best;
  }

  const Mask& centres_;
  const Tool tool_;
  const double least_share_;
  CoveredFloor& covered_;
  const std::vector<double> walls_;
  std::vector<SwathCell> swaths_;
};

}  // namespace

std::vector<SwathCell> fill_gaps(const Mask& centres, const Tool& tool, double least_share,
                                 CoveredFloor& covered) {
  Filling filling(centres, tool, least_share, covered);
  Mask left = covered.uncovered();
  for (int row = 0; row < left.grid.height; ++row) {
    for (int column = 0; column < left.grid.width; ++column) {
      if (left.cells[left.grid.offset({column, row})] == 0) continue;
      const Mask gap = take_gap(left, {column, row});
      if (gap.area_m2() >= least_m2) filling.fill(gap);
    }
  }
  return filling.take();
}

}  // namespace tocsin::coverage
