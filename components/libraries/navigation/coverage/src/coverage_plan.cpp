// SPDX-License-Identifier: Apache-2.0
#include "coverage/coverage_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "best_pattern.hpp"
#include "coverage/covered_floor.hpp"
#include "coverage/tour.hpp"
#include "fill.hpp"
#include "foundation/error.hpp"
#include "navigation/planner.hpp"

namespace tocsin::coverage {
namespace {

using geometry::Point;
using geometry::Pose;

constexpr double bow_m = 0.04;          // a path may pass a swath by so much
constexpr double shortest_leg_m = 0.2;  // shorter pieces of a swath are not divided

void require(const CoverageParams& params) {
  if (!(params.width_m >= 0.05 && params.width_m <= 5)) {
    throw ConfigError(fmt::format("width: {} m is outside [0.05, 5]", params.width_m));
  }
  if (!(params.overlap_m >= 0 && params.overlap_m < params.width_m)) {
    throw ConfigError(fmt::format("overlap: {} m is outside [0, {}), the width", params.overlap_m,
                                  params.width_m));
  }
  if (!(params.enough > 0 && params.enough <= 1)) {
    throw ConfigError(fmt::format("enough: {} is outside (0, 1]", params.enough));
  }
}

double distance_to(const Swath& line, const Point& p) {
  const double length = length_m(line);
  if (length == 0) return distance(line.from, p);
  const double along = ((p.x_m - line.from.x_m) * (line.to.x_m - line.from.x_m) +
                        (p.y_m - line.from.y_m) * (line.to.y_m - line.from.y_m)) /
                       (length * length);
  return distance(p, between(line.from, line.to, std::clamp(along, 0.0, 1.0)));
}

/// Makes stops out of swaths, and the path from one to the next.
class Drive {
 public:
  Drive(std::shared_ptr<const navigation::CostMap> costs, const Point& start)
      : planner_(std::move(costs)), path_{start} {}

  void along(const Swath& swath) {
    const double heading_rad =
        length_m(swath) > 0 ? bearing(swath.from, swath.to) : bearing(path_.back(), swath.from);
    if (!go_to(swath.from, heading_rad)) return;
    if (length_m(swath) > 0) divide({path_.back(), swath.to}, heading_rad);
    ++swaths_;
  }

  [[nodiscard]] const std::vector<Stop>& stops() const { return stops_; }
  [[nodiscard]] const geometry::Path& path() const { return path_; }
  [[nodiscard]] std::size_t swaths() const { return swaths_; }

 private:
  bool go_to(const Point& to, double heading_rad) {
    const auto way = planner_.plan(path_.back(), to);
    if (way) take(*way, heading_rad);
    return way.has_value();
  }

  void take(const geometry::Path& way, double heading_rad) {
    path_.insert(path_.end(), way.begin() + 1, way.end());
    stops_.push_back({{path_.back().x_m, path_.back().y_m, heading_rad}, swaths_});
  }

  /// In legs so short that the planner does not bow out of the swath, away from a wall.
  void divide(const Swath& leg, double heading_rad) {
    const auto way = planner_.plan(path_.back(), leg.to);
    if (!way) return;
    const bool is_straight = std::all_of(
        way->begin(), way->end(), [&](const Point& p) { return distance_to(leg, p) <= bow_m; });
    if (is_straight || length_m(leg) < 2 * shortest_leg_m) return take(*way, heading_rad);
    const Point middle = between(leg.from, leg.to, 0.5);
    divide({leg.from, middle}, heading_rad);
    divide({middle, leg.to}, heading_rad);
  }

  navigation::Planner planner_;
  geometry::Path path_;
  std::vector<Stop> stops_;
  std::size_t swaths_ = 0;
};

/// Plans with one tool and one diligence at a time.
class Planning {
 public:
  Planning(const navigation::OccupancyMap& map, const CoverageParams& params, const Area& area)
      : params_(params),
        start_(area.start),
        costs_(std::make_shared<const navigation::CostMap>(map, params.inflation)),
        floor_(reachable_floor(map, *costs_, area, params.width_m)) {}

  /// Of some plans the shortest that covers enough, or nearly.
  CoveragePlan best() {
    std::optional<CoveragePlan> best;
    for (const double narrower : {0.0, 0.05, 0.1}) {
      const double spacing_m = (params_.width_m - params_.overlap_m) * (1 - narrower);
      const Tool tool{params_.width_m, spacing_m};
      const auto cells = decompose(floor_, tool);
      for (const double least_share : {0.2, 0.1, 0.05}) {
        CoveragePlan plan = plan_of(filled(cells, tool, least_share));
        const bool is_enough = plan.share >= params_.enough;
        if (!best || cost_of(plan) < cost_of(*best)) best = std::move(plan);
        if (is_enough) break;  // more swaths only make it longer
      }
    }
    return *best;
  }

 private:
  /// A hundredth of the floor less than enough costs as much as 8 % more way.
  [[nodiscard]] double cost_of(const CoveragePlan& plan) const {
    return plan.length_to_least + 8 * std::max(0.0, params_.enough - plan.share);
  }

  [[nodiscard]] std::vector<SwathCell> filled(std::vector<SwathCell> cells, const Tool& tool,
                                              double least_share) const {
    CoveredFloor covered(floor_.floor, tool.width_m);
    for (const SwathCell& cell : cells) covered.drive(cell);
    for (SwathCell& swath : fill_gaps(floor_.centres, tool, least_share, covered)) {
      cells.push_back(std::move(swath));
    }
    return order_cells(cells, *costs_, start_);
  }

  [[nodiscard]] CoveragePlan plan_of(const std::vector<SwathCell>& cells) const {
    Drive drive(costs_, start_);
    for (const SwathCell& cell : cells) {
      for (const Swath& swath : cell) drive.along(swath);
    }
    CoveredFloor covered(floor_.floor, params_.width_m);
    covered.drive(drive.path());
    CoveragePlan plan{drive.stops(), drive.path(), floor_.floor, covered.uncovered()};
    plan.cells = cells.size();
    plan.swaths = drive.swaths();
    plan.floor_m2 = floor_.floor.area_m2();
    plan.share = covered.share();
    plan.length_m = navigation::length_m(plan.path);
    plan.length_to_least = plan.length_m * params_.width_m / plan.floor_m2;
    return plan;
  }

  const CoverageParams params_;
  const Point start_;
  std::shared_ptr<const navigation::CostMap> costs_;
  const Floor floor_;
};

}  // namespace

CoveragePlan plan_coverage(const navigation::OccupancyMap& map, const CoverageParams& params,
                           const Area& area) {
  require(params);
  return Planning(map, params, area).best();
}

}  // namespace tocsin::coverage
