// SPDX-License-Identifier: Apache-2.0
// localisation_bench MAP.yaml WALLS.yaml: drives about in a building with an RPLIDAR A1 and wheels
// that slip, and prints how far the localiser is from the truth: with and without things that no
// map shows, from unknown starts, and after the vehicle was carried off.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

#include "command_line/command.hpp"
#include "foundation/numbers.hpp"
#include "geometry/wall_file.hpp"
#include "laser_geometry/scan.hpp"
#include "laser_model/laser_model.hpp"
#include "localisation/localiser.hpp"
#include "navigation/map_loader.hpp"
#include "navigation/path_follower.hpp"
#include "navigation/planner.hpp"

namespace tocsin::bench {
namespace {

using geometry::Point;
using geometry::Pose;
using localisation::Health;
using localisation::Localiser;

constexpr double scan_s = 0.1;
constexpr std::size_t beams = 360;

struct Options {
  std::string map;
  std::string walls;
  int starts = 100;
  int drives = 20;
  std::uint64_t seed = 1;
  bool lists = false;
};

struct Building {
  navigation::OccupancyMap map;
  std::vector<geometry::Wall> walls;
};

/// The map with the boxes on it: what the vehicle drives round.
navigation::OccupancyMap with_boxes(const navigation::OccupancyMap& map,
                                    const laser::Obstacles& obstacles) {
  std::vector<navigation::Cell> cells = map.cells();
  for (const geometry::Wall& side : laser::sides_of(obstacles.boxes)) {
    const Point a{side.x1_m, side.y1_m};
    const Point b{side.x2_m, side.y2_m};
    for (int i = 0; i <= 100; ++i) {
      const auto cell = map.grid().cell_of(between(a, b, i / 100.0));
      if (cell) cells[map.grid().offset(*cell)] = navigation::Cell::occupied;
    }
  }
  return {map.grid(), std::move(cells)};
}

/// A vehicle on random ways, and what its odometry and its laser say.
class Vehicle {
 public:
  Vehicle(const Building& building, const laser::Obstacles& obstacles, std::uint64_t seed)
      : floor_(with_boxes(building.map, obstacles)),
        random_(seed),
        scene_(building.walls, obstacles),
        laser_(laser::find_laser_profile("rplidar_a1"), seed),
        planner_(
            std::make_shared<const navigation::CostMap>(floor_, navigation::InflationParams{})) {
    truth_ = {0, 0, 0};
    place_somewhere();
  }

  void place_somewhere() {
    const Point at = free_place();
    truth_ = {at.x_m, at.y_m, uniform(-pi, pi)};
    follower_.reset();
  }
  /// Until the next scan.
  laser::Scan step() {
    constexpr int parts = 5;
    for (int i = 0; i < parts; ++i) drive(scan_s / parts);
    return look();
  }
  [[nodiscard]] const Pose& truth() const { return truth_; }
  [[nodiscard]] const Pose& odom() const { return odom_; }
  [[nodiscard]] double way_m() const { return way_m_; }
  /// Wheels turn so much in vain.
  void slip(double share) { slip_ = share; }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }
  Point free_place() {
    const navigation::Grid& grid = floor_.grid();
    while (true) {
      const Point at{grid.origin.x_m + uniform(0, grid.width * grid.resolution_m),
                     grid.origin.y_m + uniform(0, grid.height * grid.resolution_m)};
      const bool is_free =
          floor_.at(at) == navigation::Cell::free && !floor_.collides(at.x_m, at.y_m, 0.35);
      if (is_free && planner_.plan({0, 0}, at)) return at;
    }
  }
  void drive(double dt_s) {
    for (int tries = 0; !follower_ || follower_->remaining_m() < 0.3; ++tries) {
      if (tries > 100) place_somewhere();  // walled in by boxes
      auto path = planner_.plan(position(truth_), free_place());
      if (!path || navigation::length_m(*path) < 1) continue;
      follower_.emplace(navigation::FollowerParams{});
      follower_->start(std::move(*path));
      (void)follower_->follow(truth_, Duration{0});
    }
    const geometry::Twist v = follower_->follow(truth_, seconds(dt_s));
    const double way_m = v.linear_mps * dt_s;
    const double turn_rad = v.angular_rad_s * dt_s;
    truth_ = compose(truth_, {way_m * (1 - slip_), 0, turn_rad * (1 - slip_)});
    way_m_ += way_m * (1 - slip_);
    std::normal_distribution<> normal;
    odom_ = compose(odom_, {way_m * (1.01 + 0.02 * normal(random_)), 0,
                            turn_rad * (1 - slip_) * (1 + 0.01 * normal(random_)) +
                                0.0005 * std::sqrt(dt_s) * normal(random_)});
    velocity_ = v;
  }
  laser::Scan look() {
    const auto ranges_m = laser_.turn(scene_, beams, 0, [this](double) { return truth_; });
    laser::ScanParams params;
    params.min_range_m = laser_.profile().min_range_m;
    params.max_range_m = laser_.profile().max_range_m;
    return laser::make_scan(ranges_m, {{}, -pi, 2 * pi / beams, 0, {}}, params);
  }

  navigation::OccupancyMap floor_;
  std::mt19937_64 random_;
  laser::Scene scene_;
  laser::LaserModel laser_;
  navigation::Planner planner_;
  std::optional<navigation::PathFollower> follower_;
  Pose truth_;
  Pose odom_;
  geometry::Twist velocity_;
  double way_m_ = 0;
  double slip_ = 0;
};

/// So many boxes on free floor that about 30 % of the beams end at them.
laser::Obstacles clutter(const Building& building, std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  const navigation::Grid& grid = building.map.grid();
  laser::Obstacles obstacles;
  std::uniform_real_distribution<> x(0, grid.width * grid.resolution_m);
  std::uniform_real_distribution<> y(0, grid.height * grid.resolution_m);
  std::uniform_real_distribution<> size(0.2, 0.7);
  while (static_cast<int>(obstacles.boxes.size()) < count) {
    const Point at{grid.origin.x_m + x(random), grid.origin.y_m + y(random)};
    const bool is_free = building.map.at(at) == navigation::Cell::free;
    if (!is_free || std::hypot(at.x_m, at.y_m) < 1) continue;
    obstacles.boxes.push_back({{at.x_m, at.y_m, x(random)}, size(random), size(random) / 2});
  }
  return obstacles;
}

double error_m(const localisation::Belief& belief, const Vehicle& vehicle) {
  return distance(position(belief.pose), position(vehicle.truth()));
}

struct Errors {
  std::vector<double> sure_m;
  int all = 0;
  std::vector<double> explained;
  std::vector<double> updates_us;
  double nees = 0;
  int wrong = 0;  ///< tracked, and farther off than 0.5 m
  int tracked = 0;
};

void note(Errors& errors, const Localiser::Estimate& estimate, const Vehicle& vehicle) {
  const double off_m = error_m(estimate.belief, vehicle);
  ++errors.all;
  errors.explained.push_back(estimate.explained);
  if (estimate.health != Health::tracked) return;
  errors.sure_m.push_back(off_m);
  ++errors.tracked;
  if (off_m > 0.5) ++errors.wrong;
  const Eigen::Vector2d off(estimate.belief.pose.x_m - vehicle.truth().x_m,
                            estimate.belief.pose.y_m - vehicle.truth().y_m);
  const Eigen::Matrix2d covariance = estimate.belief.covariance.topLeftCorner<2, 2>();
  errors.nees += off.dot(covariance.inverse() * off);
}

std::optional<Localiser::Estimate> update(Localiser& sut, Vehicle& vehicle, Errors& errors) {
  const laser::Scan scan = vehicle.step();
  const auto begin = std::chrono::steady_clock::now();
  const auto estimate = sut.update(scan, vehicle.odom());
  errors.updates_us.push_back(
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  return estimate;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return nan;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void print_tracking(const char* name, const Building& building, const Options& options, int boxes,
                    double slip) {
  Errors errors;
  for (int i = 0; i < options.drives; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    Vehicle vehicle(building, clutter(building, seed, boxes), seed);
    Localiser sut(building.map, {});
    sut.start_at(vehicle.truth(), 0.2, 0.1);
    for (int k = 0; k < 1200; ++k) {
      if (slip > 0) vehicle.slip(k % 100 < 20 ? slip : 0);
      const auto estimate = update(sut, vehicle, errors);
      if (estimate && k > 20) note(errors, *estimate, vehicle);
    }
  }
  fmt::print(
      "| {} | {:.0f} | {:.3f} | {:.3f} | {:.3f} | {} of {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} |\n",
      name, 100 * (1 - mean(errors.explained)), mean(errors.sure_m), quantile(errors.sure_m, 0.99),
      quantile(errors.sure_m, 1), errors.wrong, errors.tracked, 100.0 * errors.tracked / errors.all,
      errors.nees / errors.tracked, mean(errors.updates_us) / 1000,
      quantile(errors.updates_us, 0.99) / 1000);
  std::fflush(stdout);
}

/// After how many metres it was sure, and whether rightly; empty: not within 10 m.
struct Found {
  double way_m = 0;
  bool is_right = true;
};
std::optional<Found> drive_until_sure(Localiser& sut, Vehicle& vehicle, Errors& errors) {
  const double from_m = vehicle.way_m();
  for (int k = 0; k < 600 && vehicle.way_m() - from_m < 10; ++k) {
    const auto estimate = update(sut, vehicle, errors);
    if (!estimate || estimate->health != Health::tracked) continue;
    return Found{vehicle.way_m() - from_m, error_m(estimate->belief, vehicle) < 0.5};
  }
  return std::nullopt;
}

void print_starts(const char* name, const Building& building, const Options& options, int boxes) {
  int right = 0;
  int wrong = 0;
  std::vector<double> ways_m;
  Errors errors;
  for (int i = 0; i < options.starts; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    Vehicle vehicle(building, clutter(building, seed, boxes), seed);
    Localiser sut(building.map, {});
    sut.start_anywhere();
    const auto found = drive_until_sure(sut, vehicle, errors);
    if (!found) {
      if (options.lists) fmt::print("start {}: not found\n", seed);
      continue;
    }
    (found->is_right ? right : wrong) += 1;
    ways_m.push_back(found->way_m);
    if (options.lists && !found->is_right) fmt::print("start {}: wrong\n", seed);
  }
  fmt::print("| {} | {} | {:.1f} | {} | {:.2f} | {:.2f} | {:.1f} |\n", name, options.starts,
             100.0 * right / options.starts, wrong, quantile(ways_m, 0.5), quantile(ways_m, 0.95),
             quantile(errors.updates_us, 1) / 1000);
  std::fflush(stdout);
}

void print_kidnaps(const Building& building, const Options& options, int boxes) {
  int noticed = 0;
  int back = 0;
  int wrong = 0;
  std::vector<double> times_s;
  Errors errors;
  for (int i = 0; i < options.starts; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    Vehicle vehicle(building, clutter(building, seed, boxes), seed);
    Localiser sut(building.map, {});
    sut.start_at(vehicle.truth(), 0.1, 0.1);
    for (int k = 0; k < 50; ++k) (void)update(sut, vehicle, errors);
    vehicle.place_somewhere();
    bool is_noticed = false;
    bool is_back = false;
    bool is_wrong = false;
    for (int k = 0; k < 600 && !is_back; ++k) {
      const auto estimate = update(sut, vehicle, errors);
      if (!estimate) continue;
      const bool is_sure = estimate->health == Health::tracked;
      const bool is_right = error_m(estimate->belief, vehicle) < 0.5;
      if (k < 50 && (!is_sure || is_right)) is_noticed = true;
      if (k >= 50 && is_sure && !is_right) is_wrong = true;
      is_back = is_sure && is_right;
      if (is_back) times_s.push_back(k * scan_s);
    }
    noticed += is_noticed ? 1 : 0;
    back += is_back ? 1 : 0;
    wrong += is_wrong ? 1 : 0;
  }
  fmt::print("| {} | {:.1f} | {:.1f} | {} | {:.1f} | {:.1f} |\n", options.starts,
             100.0 * noticed / options.starts, 100.0 * back / options.starts, wrong,
             quantile(times_s, 0.5), quantile(times_s, 0.95));
}

int run(const Options& options) {
  const Building building{navigation::load_map(options.map), geometry::load_walls(options.walls)};
  fmt::print(
      "| tracking | of a scan not on the map, % | error while sure, mean m | 99 % | worst | sure "
      "and off by "
      "0.5 m | sure, % | NEES (2 is honest) | update, mean ms | 99 % |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  print_tracking("as mapped", building, options, 0, 0);
  print_tracking("with boxes", building, options, 60, 0);
  print_tracking("with more boxes", building, options, 160, 0);
  print_tracking("wheels slip half of the time", building, options, 60, 0.5);
  fmt::print(
      "\n| unknown start | starts | right within 10 m, % | sure and wrong | found after, median m "
      "| "
      "95 % | longest update, ms |\n| --- | --- | --- | --- | --- | --- | --- |\n");
  print_starts("as mapped", building, options, 0);
  print_starts("with boxes", building, options, 60);
  fmt::print(
      "\n| carried off | noticed within 5 s, % | back within a minute, % | sure and wrong after 5 "
      "s "
      "| back after, median s | 95 % |\n| --- | --- | --- | --- | --- | --- |\n");
  print_kidnaps(building, options, 60);
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  tocsin::bench::Options options;
  CLI::App app("How well the localiser knows where a vehicle is.");
  app.name("localisation_bench");
  app.add_option("MAP", options.map, "YAML of the map")->required();
  app.add_option("WALLS", options.walls, "wall segments of the same building")->required();
  app.add_option("--starts", options.starts, "unknown starts, and times it is carried off")
      ->check(CLI::Range(1, 100000));
  app.add_option("--drives", options.drives, "of two minutes")->check(CLI::Range(1, 100000));
  app.add_option("--seed", options.seed, "of the first one");
  app.add_flag("--list", options.lists, "names the starts that failed");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(options); });
}
