// SPDX-License-Identifier: Apache-2.0
#include "coverage/tour.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "foundation/numbers.hpp"
#include "navigation/distance_field.hpp"

namespace tocsin::coverage {
namespace {

using geometry::Point;

constexpr std::size_t most_exchanged = 150;
constexpr int most_rounds = 20;
constexpr double least_gain_m = 1e-3;

/// How a cell is driven. Of `corner`, bit 0: it begins with the last swath; bit 1: at its far end.
struct Visit {
  std::size_t cell = 0;
  std::size_t corner = 0;
};
using Tour = std::vector<Visit>;

std::size_t exit_corner(std::size_t entry, std::size_t swaths) {
  const std::size_t end = swaths % 2 == 1 ? 2U : 0U;
  return (entry ^ 1U) ^ end;
}

/// Ways between the corners of cells; those from a corner are computed when first asked for.
class Ways {
 public:
  Ways(const std::vector<SwathCell>& cells, const navigation::CostMap& costs, const Point& start)
      : cells_(cells), costs_(costs), start_(start), rows_(4 * cells.size() + 1) {}

  /// From the end of `from` to the beginning of `to` [m].
  [[nodiscard]] double between(const Visit& from, const Visit& to) {
    return row(exit_of(from))[4 * to.cell + to.corner];
  }
  [[nodiscard]] double from_start(const Visit& to) {
    return row(4 * cells_.size())[4 * to.cell + to.corner];
  }
  /// The same cell the other way round.
  [[nodiscard]] Visit reversed(const Visit& visit) const {
    return {visit.cell, exit_corner(visit.corner, cells_[visit.cell].size())};
  }

 private:
  [[nodiscard]] std::size_t exit_of(const Visit& visit) const {
    return 4 * visit.cell + reversed(visit).corner;
  }
  [[nodiscard]] Point point(std::size_t i) const {
    if (i == 4 * cells_.size()) return start_;
    const SwathCell& cell = cells_[i / 4];
    const Swath& swath = (i & 1U) != 0 ? cell.back() : cell.front();
    return (i & 2U) != 0 ? swath.to : swath.from;
  }
  const std::vector<float>& row(std::size_t i) {
    // A single swath is its own first and last one.
    if (i < 4 * cells_.size() && cells_[i / 4].size() == 1) i &= ~std::size_t{1};
    auto& row = rows_[i];
    if (!row.empty()) return row;
    const navigation::DistanceField field(costs_, point(i));
    for (std::size_t k = 0; k < 4 * cells_.size(); ++k) {
      row.push_back(static_cast<float>(field.distance_m(point(k))));
    }
    return row;
  }

  const std::vector<SwathCell>& cells_;
  const navigation::CostMap& costs_;
  Point start_;
  std::vector<std::vector<float>> rows_;
};

/// A tour that is made shorter.
class Shortening {
 public:
  Shortening(Ways& ways, Tour tour) : ways_(ways), tour_(std::move(tour)) {}

  Tour run() {
    for (int i = 0; i < most_rounds; ++i) {
      const bool has_moved = move_cells();
      if (!reverse_parts() && !has_moved) break;
    }
    return tour_;
  }

 private:
  /// The way into the visit at `i`, which may be after the last one.
  double way_to(std::size_t i, const Visit& visit) {
    return i == 0 ? ways_.from_start(visit) : ways_.between(tour_[i - 1], visit);
  }
  double way_from(const Visit& visit, std::size_t i) {
    return i >= tour_.size() ? 0 : ways_.between(visit, tour_[i]);
  }

  bool move_cells() {
    bool any = false;
    for (std::size_t i = 0; i < tour_.size(); ++i) any = move_cell(i) || any;
    return any;
  }

  bool move_cell(std::size_t i) {
    const Visit visit = tour_[i];
    const double with = way_to(i, visit) + way_from(visit, i + 1);
    tour_.erase(tour_.begin() + static_cast<std::ptrdiff_t>(i));
    const double without = i < tour_.size() ? way_to(i, tour_[i]) : 0;
    double best_m = with - without;
    const double before_m = best_m;
    std::size_t best_place = i;
    Visit best = visit;
    for (std::size_t place = 0; place <= tour_.size(); ++place) {
      const double straight_m = place < tour_.size() ? way_to(place, tour_[place]) : 0;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const Visit other{visit.cell, corner};
        const double more_m = way_to(place, other) + way_from(other, place) - straight_m;
        if (more_m >= best_m - least_gain_m) continue;
        best_m = more_m;
        best_place = place;
        best = other;
      }
    }
    tour_.insert(tour_.begin() + static_cast<std::ptrdiff_t>(best_place), best);
    return best_m < before_m;
  }

  bool reverse_parts() {
    bool any = false;
    for (std::size_t i = 0; i < tour_.size(); ++i) {
      for (std::size_t k = i + 1; k < tour_.size(); ++k) any = reverse_part(i, k) || any;
    }
    return any;
  }

  bool reverse_part(std::size_t first, std::size_t last) {
    const double now_m = way_to(first, tour_[first]) + way_from(tour_[last], last + 1);
    const double then_m = way_to(first, ways_.reversed(tour_[last])) +
                          way_from(ways_.reversed(tour_[first]), last + 1);
    if (then_m >= now_m - least_gain_m) return false;
    const auto begin = tour_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = tour_.begin() + static_cast<std::ptrdiff_t>(last + 1);
    std::reverse(begin, end);
    std::transform(begin, end, begin, [&](const Visit& visit) { return ways_.reversed(visit); });
    return true;
  }

  Ways& ways_;
  Tour tour_;
};

Tour nearest_first(Ways& ways, std::size_t count) {
  Tour tour;
  std::vector<bool> is_visited(count, false);
  while (tour.size() < count) {
    Visit best;
    double best_m = infinity;
    for (std::size_t i = 0; i < 4 * count; ++i) {
      const Visit visit{i / 4, i % 4};
      if (is_visited[visit.cell]) continue;
      const double way_m = tour.empty() ? ways.from_start(visit) : ways.between(tour.back(), visit);
      if (way_m >= best_m) continue;
      best_m = way_m;
      best = visit;
    }
    if (best_m == infinity) break;
    is_visited[best.cell] = true;
    tour.push_back(best);
  }
  return tour;
}

SwathCell driven(SwathCell cell, std::size_t corner) {
  if ((corner & 1U) != 0) std::reverse(cell.begin(), cell.end());
  bool is_back = (corner & 2U) != 0;
  for (Swath& swath : cell) {
    if (is_back) std::swap(swath.from, swath.to);
    is_back = !is_back;
  }
  return cell;
}

}  // namespace

std::vector<SwathCell> order_cells(const std::vector<SwathCell>& cells,
                                   const navigation::CostMap& costs, const Point& start) {
  Ways ways(cells, costs, start);
  Tour tour = nearest_first(ways, cells.size());
  if (tour.size() <= most_exchanged) tour = Shortening(ways, std::move(tour)).run();
  std::vector<SwathCell> ordered;
  for (const Visit& visit : tour) ordered.push_back(driven(cells[visit.cell], visit.corner));
  return ordered;
}

}  // namespace tocsin::coverage
