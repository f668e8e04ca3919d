// SPDX-License-Identifier: Apache-2.0
// obstacle_bench: drives through random buildings whose map shows the walls only: boxes, legs and,
// with --people, persons who walk to and fro without looking, or with --look, are in the way.
// Prints how the drives end, and how long they take against a navigator whose map shows all that
// stands.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "command_line/command.hpp"
#include "drive_run.hpp"
#include "foundation/numbers.hpp"
#include "navigation/distance_field.hpp"
#include "random_world.hpp"

namespace tocsin::bench {
namespace {

using geometry::Point;

struct Options {
  int worlds = 100;
  int people = 0;
  bool look = false;
  std::uint64_t seed = 1;
  bool lists = false;
};

struct Sums {
  std::array<int, 4> ends{};
  std::vector<double> ratios;        ///< of the time to that of who knows all
  std::vector<double> ratios_alone;  ///< to that of who is alone besides
  double way_m = 0;
  int drives = 0;
};

/// A place at least 4 m of way from the start, if there is one.
std::optional<Point> goal_of(const World& world, std::mt19937_64& random) {
  const navigation::CostMap costs(world.truth, {});
  const navigation::DistanceField field(costs, world.start);
  const navigation::Grid& grid = world.truth.grid();
  std::uniform_int_distribution<std::size_t> draw(0, grid.size() - 1);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t offset = draw(random);
    if (!field.reaches(offset) || field.distance_m(offset) < 4) continue;
    const auto width = static_cast<std::size_t>(grid.width);
    return grid.centre({static_cast<int>(offset % width), static_cast<int>(offset / width)});
  }
  return std::nullopt;
}

bool is_free_way(const World& world, const Point& a, const Point& b) {
  constexpr double person_m = 0.25;
  for (int i = 0; i <= 40; ++i) {
    const Point at = between(a, b, i / 40.0);
    if (world.truth.collides(at.x_m, at.y_m, person_m)) return false;
  }
  return true;
}

/// Whoever looks stops where a vehicle can pass him, and not on its goal.
bool is_place_to_stand(const World& world, const Point& at, const Point& goal) {
  constexpr double room_m = 0.7;
  return !world.truth.collides(at.x_m, at.y_m, room_m) && distance(at, goal) > 1;
}

/// Persons on straight ways of 2 to 6 m over free floor, none of which begins near the vehicle.
std::vector<laser::Walker> people_in(const World& world, const Options& options, const Point& goal,
                                     std::mt19937_64& random) {
  std::vector<laser::Walker> people;
  const navigation::Grid& grid = world.truth.grid();
  std::uniform_real_distribution<> x(0, grid.width * grid.resolution_m);
  std::uniform_real_distribution<> y(0, grid.height * grid.resolution_m);
  std::uniform_real_distribution<> speed(0.4, 1.2);
  for (int i = 0; i < 3000 && static_cast<int>(people.size()) < options.people; ++i) {
    const Point a{grid.origin.x_m + x(random), grid.origin.y_m + y(random)};
    const Point b{grid.origin.x_m + x(random), grid.origin.y_m + y(random)};
    const double way_m = distance(a, b);
    if (way_m < 2 || way_m > 6 || distance(a, world.start) < 1.5) continue;
    const bool may_stand =
        !options.look || (is_place_to_stand(world, a, goal) && is_place_to_stand(world, b, goal));
    if (may_stand && is_free_way(world, a, b)) people.push_back({{a, b}, speed(random), 1, 0.2});
  }
  return people;
}

Navigator::Params params_of_navigator() {
  Navigator::Params params;
  params.surroundings.avoid_obstacles = true;
  return params;
}

/// Somebody's way through a building.
struct Trip {
  const World& world;
  Point goal;
  std::uint64_t seed;
  bool look;  ///< the people
};

DriveResult drive_through(const Trip& trip, const laser::Obstacles& obstacles,
                          const navigation::OccupancyMap& map) {
  const Point& start = trip.world.start;
  DriveTask task{laser::Scene(trip.world.walls, obstacles),
                 People(obstacles.walkers, trip.look),
                 map,
                 {start.x_m, start.y_m, bearing(start, trip.goal)},
                 trip.goal,
                 300,
                 trip.seed};
  return drive(std::move(task), params_of_navigator());
}

void note_ratio(std::vector<double>& ratios, const DriveResult& result, const DriveResult& other) {
  if (result.end != DriveEnd::arrived || other.end != DriveEnd::arrived) return;
  ratios.push_back(result.time_s / other.time_s);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void drive_world(WorldKind kind, std::uint64_t seed, const Options& options, Sums& sums) {
  const World world = random_world(kind, seed);
  std::mt19937_64 random(seed * 7919 + 1);
  const auto goal = goal_of(world, random);
  if (!goal) return;
  laser::Obstacles obstacles = world.obstacles;
  obstacles.walkers = people_in(world, options, *goal, random);
  const Trip trip{world, *goal, seed, options.look};
  const DriveResult result = drive_through(trip, obstacles, world.walls_only);
  const DriveResult known = drive_through(trip, obstacles, world.truth);
  const DriveResult alone = drive_through(trip, world.obstacles, world.truth);
  ++sums.drives;
  ++sums.ends[static_cast<std::size_t>(result.end)];
  sums.way_m += result.way_m;
  note_ratio(sums.ratios, result, known);
  note_ratio(sums.ratios_alone, result, alone);
  if (options.lists && result.end != DriveEnd::arrived) {
    fmt::print("{} {}: end {} after {:.1f} s at ({:.2f}, {:.2f}) {}; who knows all: end {}\n",
               to_string(kind), seed, static_cast<int>(result.end), result.time_s, result.last.x_m,
               result.last.y_m, result.reason, static_cast<int>(known.end));
  }
}

void print_row(const char* name, Sums& sums) {
  std::sort(sums.ratios.begin(), sums.ratios.end());
  const double p95 = sums.ratios.empty() ? nan : sums.ratios[sums.ratios.size() * 95 / 100];
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", name,
             sums.drives, sums.ends[0], sums.ends[1], sums.ends[2], sums.ends[3],
             mean_of(sums.ratios), p95, mean_of(sums.ratios_alone), sums.way_m / 1000);
}

int run(const Options& options) {
  fmt::print(
      "| buildings, {} people each{} | drives | arrived | ran into something | was run into | "
      "timed "
      "out | time of who knows all, mean | 95 % | of the same without people, mean | km |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      options.people, options.look ? " who look" : "");
  for (const WorldKind kind : {WorldKind::rooms, WorldKind::corridor, WorldKind::clutter}) {
    Sums sums;
    for (int i = 0; i < options.worlds; ++i) {
      drive_world(kind, options.seed + static_cast<std::uint64_t>(i), options, sums);
    }
    print_row(to_string(kind), sums);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  tocsin::bench::Options options;
  CLI::App app("Drives round what no map shows.");
  app.name("obstacle_bench");
  app.add_option("--worlds", options.worlds, "of each kind")->check(CLI::Range(1, 100000));
  app.add_option("--people", options.people, "who walk in each")->check(CLI::Range(0, 20));
  app.add_flag("--look", options.look, "the people wait before the vehicle, and turn round");
  app.add_option("--seed", options.seed, "of the first one");
  app.add_flag("--list", options.lists, "names the drives that did not arrive");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(options); });
}
