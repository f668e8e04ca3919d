// SPDX-License-Identifier: Apache-2.0
// coverage_bench MAP.yaml: how much of its floor a planned drive covers, how long it is, and what
// planning costs, for some tools and the navigator's and a bare cost map.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "command_line/command.hpp"
#include "coverage/coverage_plan.hpp"
#include "navigation/map_loader.hpp"
#include "random_world.hpp"

namespace tocsin::bench {
namespace {

void print_row(const std::string& name, const navigation::OccupancyMap& map,
               const coverage::CoverageParams& params, const geometry::Point& start) {
  const auto begin = std::chrono::steady_clock::now();
  const auto plan = plan_coverage(map, params, {start, {}});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  fmt::print("| {} | {:.2f} | {:.0f} | {:.1f} | {:.1f} | {:.0f} | {:.2f} | {} | {} | {:.1f} |\n",
             name, params.width_m, params.inflation.soft_weight, plan.floor_m2, 100 * plan.share,
             plan.length_m, plan.length_to_least, plan.swaths, plan.stops.size(), took.count());
  std::fflush(stdout);
}

int run(const std::string& map_file) {
  fmt::print(
      "| floor | tool, m | soft_weight | m2 | covered, % | way, m | of area / width | swaths | "
      "waypoints | planned in, s |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- "
      "|\n");
  const auto map = navigation::load_map(map_file);
  for (const double soft_weight : {3.0, 0.0}) {
    for (const double width_m : {0.3, 0.4, 0.5}) {
      coverage::CoverageParams params;
      params.width_m = width_m;
      params.inflation.soft_weight = soft_weight;
      print_row("classroom and corridors", map, params, {0, 0});
    }
  }
  for (const WorldKind kind : {WorldKind::rooms, WorldKind::corridor, WorldKind::clutter}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const World world = random_world(kind, seed);
      print_row(fmt::format("{} {}", to_string(kind), seed), world.truth, {}, world.start);
    }
  }
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  std::string map_file;
  CLI::App app("Coverage of the shipped classroom and of random buildings.");
  app.name("coverage_bench");
  app.add_option("MAP", map_file, "the classroom's map")->required();
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(map_file); });
}
