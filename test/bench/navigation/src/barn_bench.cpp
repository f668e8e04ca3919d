// SPDX-License-Identifier: Apache-2.0
// barn_bench FOLDER: drives the worlds of the BARN challenge (github.com/Daffan/the-barn-challenge;
// world_*.csv: cylinders x, y, radius in metres) from (-2.25, 3) to (-2.25, 13), on a floor that
// the navigator knows nothing of at the start, and prints how the drives end.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "drive_run.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::bench {
namespace {

const geometry::Pose start{-2.25, 3, pi / 2};
const geometry::Point goal{-2.25, 13};

struct Options {
  std::string folder;
  int runs = 10;
  int every = 1;
  int first = 0;
  std::uint64_t seed = 1;
  bool lists = false;
};

struct Sums {
  int runs = 0;
  int arrived = 0;
  int collided = 0;
  int timed_out = 0;
  std::vector<double> times_s;
  std::vector<double> ways_m;
  std::vector<double> scans_us;
  std::vector<double> updates_us;
  std::vector<double> plans_us;
  std::vector<double> brakes_us;
};

std::vector<std::filesystem::path> worlds_in(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().rfind("world_", 0) == 0) files.push_back(entry.path());
  }
  if (files.empty()) throw ConfigError(folder + ": holds no world_*.csv");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<laser::Disc> load_world(const std::filesystem::path& file) {
  std::ifstream lines(file);
  std::vector<laser::Disc> discs;
  laser::Disc disc;
  for (char comma = 0;
       lines >> disc.centre.x_m >> comma >> disc.centre.y_m >> comma >> disc.radius_m;) {
    discs.push_back(disc);
  }
  if (discs.empty()) throw ConfigError(file.string() + ": holds no lines `x,y,radius`");
  return discs;
}

/// Nothing but free floor round the world, start and goal.
navigation::OccupancyMap unknown_floor(const std::vector<laser::Disc>& discs) {
  constexpr double rim_m = 2;
  geometry::Point low{start.x_m, start.y_m};
  geometry::Point high = goal;
  for (const laser::Disc& disc : discs) {
    low = {std::min(low.x_m, disc.centre.x_m), std::min(low.y_m, disc.centre.y_m)};
    high = {std::max(high.x_m, disc.centre.x_m), std::max(high.y_m, disc.centre.y_m)};
  }
  navigation::Grid grid;
  grid.origin = {low.x_m - rim_m, low.y_m - rim_m};
  grid.width = static_cast<int>((high.x_m - low.x_m + 2 * rim_m) / grid.resolution_m);
  grid.height = static_cast<int>((high.y_m - low.y_m + 2 * rim_m) / grid.resolution_m);
  return {grid, std::vector<navigation::Cell>(grid.size(), navigation::Cell::free)};
}

void add(Sums& sums, const DriveResult& result) {
  ++sums.runs;
  sums.arrived += result.end == DriveEnd::arrived ? 1 : 0;
  sums.collided += result.end == DriveEnd::collided ? 1 : 0;
  sums.timed_out += result.end == DriveEnd::timed_out ? 1 : 0;
  sums.scans_us.push_back(result.scan_us);
  sums.updates_us.push_back(result.update_us);
  sums.plans_us.push_back(result.plan_us);
  sums.brakes_us.push_back(result.brake_us);
  if (result.end != DriveEnd::arrived) return;
  sums.times_s.push_back(result.time_s);
  sums.ways_m.push_back(result.way_m);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? nan : sum / static_cast<double>(values.size());
}

void print(const Sums& sums) {
  const auto share = [&](int count) { return static_cast<double>(count) / sums.runs; };
  fmt::print(
      "| planner | drives | success | collisions | timeouts | time, s | way, m |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n"
      "| DWA of the challenge, 50 worlds x 10, Jackal | 500 | 0.880 | 0.048 | 0.072 | 33.5 | |\n"
      "| navigator and brake, Kobuki at 0.5 m/s | {} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {:.1f} "
      "|\n\n"
      "Computing, means of the drives' medians: a scan {:.0f} us, an update {:.0f} us, the longest "
      "update "
      "(with a plan) {:.0f} us; the brake {:.0f} us a scan.\n",
      sums.runs, share(sums.arrived), share(sums.collided), share(sums.timed_out),
      mean(sums.times_s), mean(sums.ways_m), mean(sums.scans_us), mean(sums.updates_us),
      mean(sums.plans_us), mean(sums.brakes_us));
}

Navigator::Params params_of_navigator() {
  Navigator::Params params;
  params.surroundings.avoid_obstacles = true;
  return params;
}

int run(const Options& options) {
  Sums sums;
  const auto files = worlds_in(options.folder);
  for (std::size_t i = static_cast<std::size_t>(options.first); i < files.size();
       i += static_cast<std::size_t>(options.every)) {
    const auto discs = load_world(files[i]);
    for (int k = 0; k < options.runs; ++k) {
      laser::Obstacles obstacles;
      obstacles.discs = discs;
      const auto seed = options.seed + static_cast<std::uint64_t>(k);
      const DriveResult result = drive(
          {laser::Scene({}, obstacles), People{}, unknown_floor(discs), start, goal, 100, seed},
          params_of_navigator());
      add(sums, result);
      if (options.lists && result.end != DriveEnd::arrived) {
        fmt::print("{} seed {}: {} after {:.1f} s at ({:.2f}, {:.2f}, {:.2f}) {}\n",
                   files[i].filename().string(), seed,
                   result.end == DriveEnd::collided ? "collided" : "timed out", result.time_s,
                   result.last.x_m, result.last.y_m, result.last.heading_rad, result.reason);
        std::fflush(stdout);
      }
    }
  }
  print(sums);
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  tocsin::bench::Options options;
  CLI::App app("Drives in the worlds of the BARN challenge.");
  app.name("barn_bench");
  app.add_option("FOLDER", options.folder, "with world_*.csv")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--runs", options.runs, "drives of each world")->check(CLI::Range(1, 1000));
  app.add_option("--every", options.every, "every so manieth world")->check(CLI::Range(1, 1000));
  app.add_option("--first", options.first, "index of the first one")->check(CLI::Range(0, 1000));
  app.add_option("--seed", options.seed, "of the first drive of each world");
  app.add_flag("--list", options.lists, "names the drives that did not arrive");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(options); });
}
