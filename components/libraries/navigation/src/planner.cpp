// SPDX-License-Identifier: Apache-2.0
#include "navigation/planner.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
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

/// The open cells, cheapest estimate first, among equals the last one put in. A ring of buckets,
/// one per estimate: with a consistent heuristic an estimate never lies below the one taken last,
/// nor above it by more than one step, so neither a heap nor a comparison is needed.
class OpenCells {
 public:
  OpenCells() : buckets_(ring_size) {}

  /// Leaves none; no estimate will be below `first`.
  void restart(std::uint32_t first) {
    for (; !empty(); ++current_) {
      auto& bucket = buckets_[current_ % ring_size];
      count_ -= bucket.size();
      bucket.clear();
    }
    current_ = first;
  }

  void put(std::uint32_t estimate, CellIndex cell) {
    assert(estimate - current_ < ring_size);
    buckets_[estimate % ring_size].push_back(cell);
    ++count_;
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::uint32_t estimate() const { return current_; }

  /// Asserts that it is not empty.
  CellIndex take() {
    assert(!empty());
    while (buckets_[current_ % ring_size].empty()) ++current_;
    auto& bucket = buckets_[current_ % ring_size];
    const CellIndex cell = bucket.back();
    bucket.pop_back();
    --count_;
    return cell;
  }

 private:
  static constexpr std::uint32_t ring_size = 8192;
  static_assert(diagonal * (CostMap::dearest + CostMap::plain) < ring_size);
  std::vector<std::vector<CellIndex>> buckets_;
  std::uint32_t current_ = 0;
  std::size_t count_ = 0;
};

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
      if (there == 0 || sum >= cost_[offset] || (i >= 4 && cuts_corner(from, to))) continue;
      open(to, sum, static_cast<std::uint8_t>(i));
    }
  }

  bool cuts_corner(CellIndex from, CellIndex to) const {
    return map_.cost(grid_.offset({to.column, from.row})) == 0 ||
           map_.cost(grid_.offset({from.column, to.row})) == 0;
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

std::optional<CellIndex> nearest_free(const CostMap& map, const geometry::Point& p,
                                      double reach_m) {
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

std::optional<geometry::Path> Planner::plan(const geometry::Point& start,
                                            const geometry::Point& goal) {
  const CostMap& map = *map_;
  const auto from = nearest_free(map, start, start_reach_m);
  const auto to = nearest_free(map, goal, goal_reach_m);
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
