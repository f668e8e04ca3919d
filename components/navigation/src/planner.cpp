// SPDX-License-Identifier: Apache-2.0
#include "navigation/planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <queue>
#include <vector>

namespace tocsin::navigation {
namespace {

constexpr double start_reach_m = 0.5;
constexpr double goal_reach_m = 0.15;
constexpr std::uint32_t straight = 10;  // lengths of steps, in tenths of a cell
constexpr std::uint32_t diagonal = 14;
constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint8_t no_step = 8;

constexpr std::array<CellIndex, 8> steps{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

CellIndex add(CellIndex a, CellIndex b) { return {a.column + b.column, a.row + b.row}; }

/// A cell to expand. Ties go to the one nearer to the goal, then to the lower offset.
struct Open {
  std::uint32_t estimate;
  std::uint32_t rest;
  std::uint32_t offset;
  bool operator<(const Open& o) const {  // std::priority_queue pops the greatest
    if (estimate != o.estimate) return estimate > o.estimate;
    return rest != o.rest ? rest > o.rest : offset > o.offset;
  }
};

class Search {
 public:
  Search(const CostMap& map, CellIndex start, CellIndex goal)
      : map_(map),
        grid_(map.grid()),
        start_(start),
        goal_(goal),
        cost_(grid_.size(), unreached),
        came_by_(grid_.size(), no_step) {}

  /// Cells from start to goal, empty when the goal cannot be reached.
  std::vector<CellIndex> run() {
    open(start_, 0, no_step);
    while (!open_.empty()) {
      const Open best = open_.top();
      open_.pop();
      const CellIndex cell = cell_at(best.offset);
      const std::uint32_t cost = cost_[best.offset];
      if (best.estimate != cost + best.rest) continue;  // reached cheaper meanwhile
      if (cell.column == goal_.column && cell.row == goal_.row) return trace();
      expand(cell, cost);
    }
    return {};
  }

 private:
  CellIndex cell_at(std::uint32_t offset) const {
    const int i = static_cast<int>(offset);
    return {i % grid_.width, i / grid_.width};
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
    if (cost >= cost_[offset]) return;
    cost_[offset] = cost;
    came_by_[offset] = step;
    const std::uint32_t h = rest(c);
    open_.push({cost + h, h, static_cast<std::uint32_t>(offset)});
  }

  void expand(CellIndex from, std::uint32_t cost) {
    const std::uint32_t here = map_.cost(grid_.offset(from));
    for (std::uint8_t i = 0; i < steps.size(); ++i) {
      const CellIndex to = add(from, steps[i]);
      if (map_.blocked(to) || cuts_corner(from, steps[i])) continue;
      const std::uint32_t length = i < 4 ? straight : diagonal;
      open(to, cost + length * (here + map_.cost(grid_.offset(to))) / 2, i);
    }
  }

  bool cuts_corner(CellIndex from, CellIndex step) const {
    return map_.blocked(CellIndex{from.column + step.column, from.row}) ||
           map_.blocked(CellIndex{from.column, from.row + step.row});
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
  CellIndex start_;
  CellIndex goal_;
  std::vector<std::uint32_t> cost_;
  std::vector<std::uint8_t> came_by_;
  std::priority_queue<Open> open_;
};

std::optional<CellIndex> nearest_free(const CostMap& map, const Point2& p, double reach_m) {
  const Grid& grid = map.grid();
  const auto middle = grid.cell_of(p);
  if (!middle || !map.blocked(*middle)) return middle;
  const int reach = static_cast<int>(reach_m / grid.resolution_m);
  std::optional<CellIndex> best;
  double best_m = reach_m;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const CellIndex cell = add(*middle, {column, row});
      const double away_m = distance(p, grid.centre(cell));
      if (map.blocked(cell) || away_m >= best_m) continue;
      best = cell;
      best_m = away_m;
    }
  }
  return best;
}

/// Cost of the straight line, infinite when it crosses a blocked cell.
double line_cost(const CostMap& map, const Point2& a, const Point2& b) {
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
std::vector<double> running_costs(const CostMap& map, const Path& path) {
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    sums.push_back(sums.back() + line_cost(map, path[i - 1], path[i]));
  }
  return sums;
}

/// The farthest point that a straight line from `from` reaches at no more than 1 % extra cost.
/// Looks on behind a failure, because the steps of a grid path make the comparison uneven.
std::size_t farthest(const CostMap& map, const Path& path, const std::vector<double>& sums,
                     std::size_t from) {
  constexpr std::size_t patience = 30;
  std::size_t best = from + 1;
  for (std::size_t to = from + 2; to < path.size() && to <= best + patience; ++to) {
    const double limit = 1.01 * (sums[to] - sums[from]);
    if (line_cost(map, path[from], path[to]) <= limit) best = to;
  }
  return best;
}

Path straightened(const CostMap& map, const Path& path) {
  const auto sums = running_costs(map, path);
  Path result{path.front()};
  for (std::size_t i = 0; i + 1 < path.size();) {
    i = farthest(map, path, sums, i);
    result.push_back(path[i]);
  }
  return result;
}

/// Replaces an end by the exact point when that is not blocked itself.
void pin(const CostMap& map, Point2& end, const Point2& exact) {
  if (!map.blocked(exact)) end = exact;
}

}  // namespace

std::optional<Path> plan(const CostMap& map, const Point2& start, const Point2& goal) {
  const auto from = nearest_free(map, start, start_reach_m);
  const auto to = nearest_free(map, goal, goal_reach_m);
  if (!from || !to) return std::nullopt;
  const auto cells = Search(map, *from, *to).run();
  if (cells.empty()) return std::nullopt;
  Path path;
  for (const CellIndex c : cells) path.push_back(map.grid().centre(c));
  if (path.size() == 1) path.push_back(path.front());
  pin(map, path.front(), start);
  pin(map, path.back(), goal);
  Path result = straightened(map, path);
  if (map.blocked(start)) result.insert(result.begin(), start);
  return result;
}

double length_m(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
  return sum;
}

}  // namespace tocsin::navigation
