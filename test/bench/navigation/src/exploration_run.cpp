// SPDX-License-Identifier: Apache-2.0
#include "exploration_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

#include "exploration/explorer.hpp"
#include "foundation/numbers.hpp"
#include "laser_model/laser_model.hpp"
#include "mapping/occupancy_grid.hpp"
#include "navigation/planner.hpp"

namespace tocsin::bench {
namespace {

using exploration::Step;
using geometry::Point;

constexpr double choose_every_m = 0.5;
constexpr double look_every_m = 0.1;  // 5 Hz at 0.5 m/s
constexpr std::size_t beams = 360;
constexpr int most_goals = 1000;
constexpr double radius_m = 0.18;

class Vehicle {
 public:
  Vehicle(const World& world, double failing, std::uint64_t seed)
      : world_(world),
        failing_(failing),
        scene_(world.walls, world.obstacles),
        laser_(laser::find_laser_profile("rplidar_a1"), seed),
        random_(seed),
        explorer_({}),
        robot_(world.start) {
    look();
  }

  ExplorationRun run() {
    while (run_.goals < most_goals && !run_.has_ended) step();
    run_.share_known = share_known();
    run_.listed = explorer_.listed().size();
    return run_;
  }

 private:
  void look() {
    const geometry::Pose at{robot_.x_m, robot_.y_m, heading_rad_};
    const auto ranges = laser_.turn(scene_, beams, 0, [&](double) { return at; });
    const laser::Beams lie{{}, -pi, 2 * pi / beams, 0, {}};
    laser::ScanParams params;
    params.max_range_m = laser_.profile().max_range_m;
    grid_.insert(laser::make_scan(ranges, lie, params), at);
  }

  /// Every 0.1 m.
  void look_on_the_way() {
    if (distance(robot_, looked_at_) < look_every_m) return;
    looked_at_ = robot_;
    look();
  }

  void step() {
    const navigation::OccupancyMap map = grid_.map();
    const auto begin = std::chrono::steady_clock::now();
    const Step step = explorer_.next(map, robot_);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    run_.choices_ms.push_back(took.count());
    if (step.what == Step::What::done) run_.has_ended = true;
    if (step.what == Step::What::wait) look();
    if (step.what == Step::What::drive) begin_goal();
    if (step.what == Step::What::drive || step.what == Step::What::keep) advance(map, step.goal);
  }

  void begin_goal() {
    ++run_.goals;
    will_fail_ = std::uniform_real_distribution<>()(random_) < failing_;
  }

  /// Half a metre towards the goal.
  void advance(const navigation::OccupancyMap& map, const Point& goal) {
    navigation::Planner planner(
        std::make_shared<const navigation::CostMap>(map, navigation::InflationParams{}));
    const auto path = planner.plan(robot_, goal);
    if (!path || will_fail_) return explorer_.on_failed("no way");
    const Point before = robot_;
    double left_m = choose_every_m;
    for (std::size_t i = 1; i < path->size() && left_m > 0; ++i) {
      const double length_m = distance((*path)[i - 1], (*path)[i]);
      const double driven_m = std::min(length_m, left_m);
      if (!drive((*path)[i - 1], (*path)[i], driven_m)) {
        ++run_.bumps;
        robot_ = before;  // backs up
        look();
        return explorer_.on_failed("bumped into something");
      }
      left_m -= driven_m;
    }
    look();
    if (distance(robot_, goal) < 0.1) explorer_.on_reached();
  }

  /// False: it touched something.
  bool drive(const Point& from, const Point& to, double driven_m) {
    const double length_m = distance(from, to);
    if (length_m == 0) return true;
    heading_rad_ = bearing(from, to);
    for (double at_m = 0; at_m < driven_m + 0.02; at_m += 0.02) {
      const Point p = between(from, to, std::min(at_m, driven_m) / length_m);
      if (world_.truth.collides(p.x_m, p.y_m, radius_m)) return false;
      robot_ = p;
      look_on_the_way();
    }
    run_.path_m += driven_m;
    return true;
  }

  double share_known() const {
    const navigation::CostMap costs(world_.truth, {});
    const navigation::DistanceField ways(costs, world_.start);
    double all = 0;
    double known = 0;
    const navigation::Grid& grid = world_.truth.grid();
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        if (!ways.reaches(grid.offset({column, row}))) continue;
        ++all;
        known += grid_.at(grid.centre({column, row})) != navigation::Cell::unknown;
      }
    }
    return all > 0 ? known / all : 1;
  }

  const World& world_;
  const double failing_;
  laser::Scene scene_;
  laser::LaserModel laser_;
  std::mt19937_64 random_;
  exploration::Explorer explorer_;
  mapping::OccupancyGrid grid_{0.05};
  Point robot_;
  Point looked_at_;
  double heading_rad_ = 0;
  bool will_fail_ = false;
  ExplorationRun run_;
};

}  // namespace

ExplorationRun explore(const World& world, double failing, std::uint64_t seed) {
  return Vehicle(world, failing, seed).run();
}

}  // namespace tocsin::bench
