// SPDX-License-Identifier: Apache-2.0
#include "navigation/planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "open_cells.hpp"

namespace tocsin::navigation {
namespace {

constexpr double goal_reach_m = 0.15;
constexpr std::uint8_t no_step = 8;

}  // namespace

class Planner::Search {
 public:
  explicit Search(const CostMap& map)
      : map_(map),
        grid_(map.grid()),
        cost_(grid_.size(), unreached),
        came_by_(grid_.size(), no_step) {}

  /// Cells from start to goal, empty when the goal cannot be reached.
  std::vector<CellIndex> run(CellIndex start, CellIndex goal) {
    forget();
    goal_ = goal;
    open_.restart(rest(start));
    open(start, 0, no_step);
    while (!open_.empty()) {
      const CellIndex cell = open_.take();
      const std::size_t offset = grid_.offset(cell);
      if (open_.estimate() != cost_[offset] + rest(cell)) continue;  // reached cheaper meanwhile
      if (cell.column == goal_.column && cell.row == goal_.row) return trace();
      expand(cell, cost_[offset]);
    }
    return {};
  }

 private:
  void forget() {
    for (const std::size_t offset : reached_) cost_[offset] = unreached;
    reached_.clear();
  }

  std::uint32_t rest(CellIndex c) const {
    const auto dx = static_cast<std::uint32_t>(std::abs(c.column - goal_.column));
    const auto dy = static_cast<std::uint32_t>(std::abs(c.row - goal_.row));
    const std::uint32_t cells =
        straight * std::max(dx, dy) + (diagonal - straight) * std::min(dx, dy);
    return cells * CostMap::plain;
  }

  void open(CellIndex c, std::uint32_t cost, std::uint8_t step) {
    const std::size_t offset = grid_.offset(c);
    if (cost_[offset] == unreached) reached_.push_back(offset);
    cost_[offset] = cost;
    came_by_[offset] = step;
    open_.put(cost + rest(c), c);
  }

  /// The rim of the map is blocked, so a cell that is open has all eight neighbours.
  void expand(CellIndex from, std::uint32_t cost) {
    const std::size_t at = grid_.offset(from);
    const std::uint32_t here = map_.cost(at);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const CellIndex to = add(from, steps[i]);
      const std::size_t offset = grid_.offset(to);
      const std::uint32_t there = map_.cost(offset);
      const std::uint32_t length = i < 4 ? straight : diagonal;
      const std::uint32_t sum = cost + length * (here + there) / 2;
      if (there == 0 || sum >= cost_[offset] || (i >= 4 && cuts_corner(map_, from, to))) continue;
      open(to, sum, static_cast<std::uint8_t>(i));
    }
  }

  std::vector<CellIndex> trace() const {
    std::vector<CellIndex> cells{goal_};
    while (came_by_[grid_.offset(cells.back())] != no_step) {
      const CellIndex step = steps[came_by_[grid_.offset(cells.back())]];
      cells.push_back({cells.back().column - step.column, cells.back().row - step.row});
    }
    std::reverse(cells.begin(), cells.end());
    return cells;
  }

  const CostMap& map_;
  const Grid& grid_;
  CellIndex goal_;
  std::vector<std::uint32_t> cost_;    // of the cells reached, from the start
  std::vector<std::uint8_t> came_by_;  // of them
  std::vector<std::size_t> reached_;
  OpenCells open_;
};

namespace {

/// Cost of the straight line, infinite when it crosses a blocked cell.
double line_cost(const CostMap& map, const geometry::Point& a, const geometry::Point& b) {
  const double length = distance(a, b);
  const int samples = std::max(1, static_cast<int>(length / (0.5 * map.grid().resolution_m)));
  double sum = 0;
  for (int i = 0; i <= samples; ++i) {
    const auto cell = map.grid().cell_of(between(a, b, double(i) / samples));
    if (!cell || map.blocked(*cell)) return std::numeric_limits<double>::infinity();
    sum += map.cost(map.grid().offset(*cell)) * (i == 0 || i == samples ? 0.5 : 1.0);
  }
  return sum * length / samples;
}

/// Cost from the first point up to each.
std::vector<double> running_costs(const CostMap& map, const geometry::Path& path) {
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    sums.push_back(sums.back() + line_cost(map, path[i - 1], path[i]));
  }
  return sums;
}

/// A far point that a straight line from `from` reaches at no more than 1 % extra cost. Looks ahead
/// in strides that double after a success and halve after a failure.
std::size_t farthest(const CostMap& map, const geometry::Path& path,
                     const std::vector<double>& sums, std::size_t from) {
  std::size_t best = from + 1;
  for (std::size_t stride = 32; stride > 0 && best + 1 < path.size();) {
    const std::size_t to = std::min(best + stride, path.size() - 1);
    const bool is_cheap = line_cost(map, path[from], path[to]) <= 1.01 * (sums[to] - sums[from]);
    if (is_cheap) best = to;
    stride = is_cheap ? stride * 2 : stride / 2;
  }
  return best;
}

geometry::Path straightened(const CostMap& map, const geometry::Path& path) {
  const auto sums = running_costs(map, path);
  geometry::Path result{path.front()};
  for (std::size_t i = 0; i + 1 < path.size();) {
    i = farthest(map, path, sums, i);
    result.push_back(path[i]);
  }
  return result;
}

/// Replaces an end by the exact point when that is not blocked itself.
void pin(const CostMap& map, geometry::Point& end, const geometry::Point& exact) {
  if (!map.blocked(exact)) end = exact;
}

}  // namespace

Planner::Planner(std::shared_ptr<const CostMap> map)
    : map_(std::move(map)), search_(std::make_unique<Search>(*map_)) {}

Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

std::optional<geometry::Path> Planner::plan(const geometry::Point& start,
                                            const geometry::Point& goal) {
  const CostMap& map = *map_;
  const auto from = map.nearest_free(start, start_reach_m);
  const auto to = map.nearest_free(goal, goal_reach_m);
  if (!from || !to) return std::nullopt;
  const auto cells = search_->run(*from, *to);
  if (cells.empty()) return std::nullopt;
  geometry::Path path;
  for (const CellIndex c : cells) path.push_back(map.grid().centre(c));
  if (path.size() == 1) path.push_back(path.front());
  pin(map, path.front(), start);
  pin(map, path.back(), goal);
  geometry::Path result = straightened(map, path);
  if (map.blocked(start)) result.insert(result.begin(), start);
  return result;
}

double length_m(const geometry::Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
  return sum;
}

}  // namespace tocsin::navigation
