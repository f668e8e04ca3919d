// SPDX-License-Identifier: Apache-2.0
#include "navigator/surroundings.hpp"

#include <algorithm>
#include <utility>

namespace tocsin {
namespace {

constexpr double tight_margin_m = 0.02;

}  // namespace

Surroundings::Surroundings(const Params& params, const navigation::InflationParams& inflation,
                           navigation::OccupancyMap map,
                           std::shared_ptr<const navigation::CostMap> costs)
    : params_(params),
      inflation_(inflation),
      map_(std::move(map)),
      costs_(std::move(costs)),
      planned_costs_(costs_),
      planner_(costs_),
      obstacles_(map_, params.obstacles),
      chooser_(params.link_detour) {}

void Surroundings::set_map(const navigation::OccupancyMap& map) {
  is_growing_ = true;
  map_ = map;
  costs_ = std::make_shared<const navigation::CostMap>(map, inflation_);
  if (link_) link_cells_ = link_->on(costs_->grid());
  plan_over(costs_);
  obstacles_.set_map(map);
}

void Surroundings::on_scan(const laser::Scan& scan, const geometry::Pose& pose, Time now) {
  if (!params_.avoid_obstacles || !is_finite(pose)) return;
  obstacles_.on_scan(scan, pose, now);
  obstacles_.forget(now);
  seen_ = now;
}

void Surroundings::on_touch(const geometry::Point& at, Time now) {
  if (params_.avoid_obstacles) obstacles_.on_touch(at, now);
}

void Surroundings::set_link(navigation::LinkRisk risk) {
  link_ = std::move(risk);
  link_cells_ = link_->on(costs_->grid());
  has_new_link_ = params_.link_detour > 0;
}

bool Surroundings::sees(Time now) const {
  return !params_.avoid_obstacles || (seen_ && now - *seen_ <= seconds(params_.scan_timeout_s));
}

std::optional<geometry::Path> Surroundings::plan(const geometry::Point& from,
                                                 const geometry::Point& to, Time now) {
  planned_ = now;
  has_new_link_ = false;
  choice_.reset();
  auto path = shortest(from, to, now);
  if (!path || !link_ || params_.link_detour == 0) return path;
  choice_ = chooser_.choose(std::move(*path), *planned_costs_, *link_, link_cells_);
  return choice_->way.path;
}

std::optional<geometry::Path> Surroundings::shortest(const geometry::Point& from,
                                                     const geometry::Point& to, Time now) {
  const auto cells = obstacles_.cells();
  if (obstacles_.version() != planned_version_) {
    planned_version_ = obstacles_.version();
    plan_over(std::make_shared<const navigation::CostMap>(*costs_, cells, inflation_));
  }
  auto path = planner_.plan(from, to);
  if (path || (cells.empty() && !is_growing_)) return path;
  path = plan_tight(cells, from, to);
  if (path || cells.empty()) return path;
  const auto lasting = obstacles_.lasting_cells(from, now);
  return lasting.size() < cells.size() ? plan_tight(lasting, from, to) : std::nullopt;
}

/// Obstacles, and walls of a map that is being made, are seen to a cell: a gap that is wide enough
/// may look closed.
std::optional<geometry::Path> Surroundings::plan_tight(
    const std::vector<navigation::CellIndex>& obstacles, const geometry::Point& from,
    const geometry::Point& to) const {
  navigation::InflationParams tight = inflation_;
  tight.margin_m = std::min(tight.margin_m, tight_margin_m);
  const navigation::CostMap walls =
      is_growing_ ? navigation::CostMap(map_, tight) : navigation::CostMap(*costs_);
  return navigation::Planner(std::make_shared<const navigation::CostMap>(walls, obstacles, tight))
      .plan(from, to);
}

std::vector<std::int8_t> Surroundings::cost_percents(const navigation::CellWindow& window) const {
  const auto cells = obstacles_.cells();
  return navigation::cost_percents({*costs_, cells, inflation_}, map_, cells, window);
}

void Surroundings::plan_over(std::shared_ptr<const navigation::CostMap> costs) {
  planned_costs_ = std::move(costs);
  planner_ = navigation::Planner(planned_costs_);
}

bool Surroundings::wants_plan(Time now) const {
  const bool has_changed = obstacles_.version() != planned_version_ || has_new_link_;
  return planned_ && has_changed && now - *planned_ >= seconds(params_.replan_period_s);
}

bool Surroundings::collides(double x_m, double y_m, double radius_m) const {
  return map_.collides(x_m, y_m, radius_m) || obstacles_.touches({x_m, y_m}, radius_m);
}

bool Surroundings::is_clear(double x_m, double y_m, double reach_m) const {
  return map_.is_clear(x_m, y_m, reach_m) && !obstacles_.touches({x_m, y_m}, reach_m);
}

double Surroundings::obstacle_distance_m(const geometry::Point& from, double most_m) const {
  return obstacles_.distance_m(from, most_m);
}

}  // namespace tocsin
