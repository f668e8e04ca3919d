// SPDX-License-Identifier: Apache-2.0
#include "navigation/obstacle_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin::navigation {
namespace {

constexpr int passes_to_clear = 2;
constexpr double same_m = 0.25;  // what is seen so near to where something was touched is that
constexpr Duration seen_lately = std::chrono::milliseconds(500);
constexpr Duration settles_after = std::chrono::seconds(10);
constexpr double walks_beyond_m = 2;

std::size_t bin_of(double bearing_rad, std::size_t bins) {
  const double share = geometry::wrap_angle(bearing_rad) / (2 * pi) + 0.5;
  return std::min(bins - 1, static_cast<std::size_t>(share * static_cast<double>(bins)));
}

/// The beam's own bin and its neighbours: beams lie up to a degree apart.
template <class Reach>
void note_beam(Reach& reach, const geometry::Point& from, const geometry::Point& to) {
  const double length_m = distance(from, to);
  const std::size_t middle = bin_of(bearing(from, to), reach.size());
  for (const std::size_t step : {reach.size() - 1, std::size_t{0}, std::size_t{1}}) {
    double& bin = reach[(middle + step) % reach.size()];
    if (bin == 0 || length_m < bin) bin = length_m;
  }
}

/// Of the row or column at a distance from the grid's edge, the nearest one that there is.
int index_of(double from_edge_m, const Grid& grid, int count) {
  const double index = std::floor(from_edge_m / grid.resolution_m);
  return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

ObstacleLayer::ObstacleLayer(OccupancyMap map, const ObstacleParams& params)
    : map_(std::move(map)), params_(params), is_marked_(map_.grid().size(), 0) {}

void ObstacleLayer::set_map(OccupancyMap map) {
  const std::map<std::size_t, Mark> before = std::exchange(marks_, {});
  const Grid grid = map_.grid();
  map_ = std::move(map);
  is_marked_.assign(map_.grid().size(), 0);
  for (const auto& [offset, mark] : before) {
    const int width = grid.width;
    const CellIndex was{static_cast<int>(offset % static_cast<std::size_t>(width)),
                        static_cast<int>(offset / static_cast<std::size_t>(width))};
    const auto cell = map_.grid().cell_of(grid.centre(was));
    if (!cell || map_.at(*cell) == Cell::occupied) continue;
    marks_[map_.grid().offset(*cell)] = mark;
    is_marked_[map_.grid().offset(*cell)] = 1;
  }
  ++version_;
}

void ObstacleLayer::on_scan(const laser::Scan& scan, const geometry::Pose& pose, Time now) {
  const laser::Points from = laser::transformed({scan.laser}, pose);
  const laser::Points hits = laser::transformed(scan.hits, pose);
  Reach reach{};
  for (const geometry::Point& hit : hits) note_beam(reach, from.front(), hit);
  for (const geometry::Point& end : laser::transformed(scan.open, pose)) {
    note_beam(reach, from.front(), end);
  }
  for (const geometry::Point& hit : hits) {
    if (distance(from.front(), hit) <= params_.obstacle_range_m) mark(hit, now);
  }
  clear(from.front(), reach, now);
}

void ObstacleLayer::mark(const geometry::Point& hit, Time now) {
  const auto cell = map_.grid().cell_of(hit);
  if (!cell || map_.at(*cell) != Cell::free) return;
  const std::size_t offset = map_.grid().offset(*cell);
  const auto known = marks_.find(offset);
  if (known != marks_.end()) {
    known->second.seen = now;
    known->second.passed = 0;
    return;
  }
  if (map_.collides(hit.x_m, hit.y_m, params_.map_gap_m)) return;
  marks_[offset] = {now, now};
  is_marked_[offset] = 1;
  ++version_;
}

void ObstacleLayer::on_touch(const geometry::Point& at, Time now) {
  const auto cell = map_.grid().cell_of(at);
  if (!cell) return;
  const std::size_t offset = map_.grid().offset(*cell);
  const bool is_seen = sees_near(at, now);
  Mark& mark = marks_.try_emplace(offset, Mark{now, now}).first->second;
  mark.seen = now;
  if (!is_seen) mark.kept_until = now + seconds(params_.remember_touch_s);
  if (is_marked_[offset] == 0) ++version_;
  is_marked_[offset] = 1;
}

bool ObstacleLayer::sees_near(const geometry::Point& at, Time now) const {
  return std::any_of(marks_.begin(), marks_.end(), [&](const auto& known) {
    const auto& [offset, mark] = known;
    return mark.kept_until == Time::min() && now - mark.seen <= seen_lately &&
           distance(at, map_.grid().centre(cell_at(offset))) <= same_m;
  });
}

/// A cell is passed through when the beams towards its middle end behind it.
void ObstacleLayer::clear(const geometry::Point& from, const Reach& reach, Time now) {
  const double cell_m = map_.grid().resolution_m;
  for (auto at = marks_.begin(); at != marks_.end();) {
    const auto here = at++;
    Mark& mark = here->second;
    const geometry::Point middle = map_.grid().centre(cell_at(here->first));
    const double beam_m = reach[bin_of(bearing(from, middle), reach.size())];
    const bool is_passed = beam_m > distance(from, middle) + 2 * cell_m;
    if (mark.seen == now || !is_passed) continue;
    if (++mark.passed >= passes_to_clear && now >= mark.kept_until) erase(here);
  }
}

void ObstacleLayer::clear_all() {
  while (!marks_.empty()) erase(marks_.begin());
}

void ObstacleLayer::forget(Time now) {
  for (auto at = marks_.begin(); at != marks_.end();) {
    const auto here = at++;
    const bool is_old = now - here->second.seen > seconds(params_.forget_after_s);
    if (is_old && now >= here->second.kept_until) erase(here);
  }
}

void ObstacleLayer::erase(std::map<std::size_t, Mark>::iterator at) {
  is_marked_[at->first] = 0;
  marks_.erase(at);
  ++version_;
}

CellIndex ObstacleLayer::cell_at(std::size_t offset) const {
  const auto width = static_cast<std::size_t>(map_.grid().width);
  return {static_cast<int>(offset % width), static_cast<int>(offset / width)};
}

std::vector<CellIndex> ObstacleLayer::cells() const {
  std::vector<CellIndex> cells;
  cells.reserve(marks_.size());
  for (const auto& [offset, mark] : marks_) cells.push_back(cell_at(offset));
  return cells;
}

std::vector<CellIndex> ObstacleLayer::lasting_cells(const geometry::Point& from, Time now) const {
  std::vector<CellIndex> cells;
  for (const auto& [offset, mark] : marks_) {
    const CellIndex cell = cell_at(offset);
    const bool may_walk = now - mark.since < settles_after && now >= mark.kept_until &&
                          distance(map_.grid().centre(cell), from) > walks_beyond_m;
    if (!may_walk) cells.push_back(cell);
  }
  return cells;
}

bool ObstacleLayer::touches(const geometry::Point& at, double radius_m) const {
  return distance_m(at, radius_m) < radius_m;
}

double ObstacleLayer::distance_m(const geometry::Point& at, double most_m) const {
  const Grid& grid = map_.grid();
  if (marks_.empty() || !is_finite(at)) return most_m;
  const auto column = [&](double x_m) { return index_of(x_m - grid.origin.x_m, grid, grid.width); };
  const auto row = [&](double y_m) { return index_of(y_m - grid.origin.y_m, grid, grid.height); };
  const int last_column = column(at.x_m + most_m);
  const int last_row = row(at.y_m + most_m);
  double nearest_m = most_m;
  for (int r = row(at.y_m - most_m); r <= last_row; ++r) {
    for (int c = column(at.x_m - most_m); c <= last_column; ++c) {
      if (is_marked_[grid.offset({c, r})] == 0) continue;
      nearest_m = std::min(nearest_m, distance(at, grid.centre({c, r})));
    }
  }
  return nearest_m;
}

}  // namespace tocsin::navigation
