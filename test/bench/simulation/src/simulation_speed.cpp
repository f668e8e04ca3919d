// SPDX-License-Identifier: Apache-2.0
// How fast the main job runs in simulated time, with and without its parts.
// usage: simulation_speed [MISSIONS [SECONDS [ROW]]]   missions with seeds 1.. (default 5), each of
// so many simulated seconds (0: until it is over), all rows or one. CPU time of one thread.
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "simulation/sim_world.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tocsin;

struct Setup {
  const char* name;
  std::vector<std::string> without;  // components
  bool digest;
  std::vector<std::string> set;
};

struct Effort {
  double load_s = 0;
  double build_s = 0;
  double run_s = 0;
  double simulated_s = 0;
  simulation::Outcome last;
};

double cpu_s() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

void run_one(const Setup& setup, int seed, double duration_s, Effort& effort) {
  const fs::path share =
      fs::read_symlink("/proc/self/exe").parent_path() / "../../bringup/share/tocsin";
  const fs::path run_dir = fs::temp_directory_path() / ("sim_speed_" + std::to_string(::getpid()));
  fs::remove_all(run_dir);
  fs::create_directory(run_dir);
  deployment::Overrides overrides;
  overrides.share = fs::canonical(share).string();
  overrides.run_dir = run_dir.string();
  overrides.seed = seed;
  overrides.set = setup.set;
  const double start = cpu_s();
  const auto deployment = load_deployment(overrides.share + "/bringup/mission.yaml", overrides);
  const double loaded = cpu_s();
  simulation::WorldOptions options;
  options.digest = setup.digest;
  options.without = setup.without;
  options.ends_with_mission = duration_s <= 0;
  simulation::SimWorld world(deployment, options);
  const double built = cpu_s();
  effort.last = world.run(seconds(duration_s > 0 ? duration_s : 3600));
  effort.run_s += cpu_s() - built;
  effort.load_s += loaded - start;
  effort.build_s += built - loaded;
  effort.simulated_s += to_seconds(effort.last.simulated);
  fs::remove_all(run_dir);
}

void print(const Setup& setup, const Effort& e, int missions) {
  const double all_s = e.load_s + e.build_s + e.run_s;
  std::printf("%-44s %8.0f %8.0f  %7.2f %7.2f %8.3f  %6.0f %6.0f %6.0f\n", setup.name,
              e.simulated_s / all_s, e.simulated_s / e.run_s, 1e3 * e.load_s / missions,
              1e3 * e.build_s / missions, 1e3 * e.run_s / e.simulated_s,
              static_cast<double>(e.last.samples) / to_seconds(e.last.simulated),
              static_cast<double>(e.last.packets) / to_seconds(e.last.simulated),
              static_cast<double>(e.last.ticks) / to_seconds(e.last.simulated));
}

}  // namespace

int main(int argc, char** argv) {
  const int missions = argc > 1 ? std::atoi(argv[1]) : 5;
  const double duration_s = argc > 2 ? std::atof(argv[2]) : 0;
  const std::string drawn = "camera.in_simulated_time=drawn";
  const std::vector<Setup> setups{
      {"everything, pictures drawn", {}, true, {drawn}},
      {"everything, pictures of the right size", {}, true, {}},
      {"no digest", {}, false, {}},
      {"no recorders", {"recorder"}, true, {}},
      {"no recorders, no digest", {"recorder"}, false, {}},
      {"no recorders, no digest, no camera", {"recorder", "camera"}, false, {}},
  };
  std::printf("%d missions; CPU time of one thread\n", missions);
  std::printf("%-44s %8s %8s  %7s %7s %8s  %6s %6s %6s\n", "", "times rt", "run only", "load ms",
              "build ms", "ms per s", "smpl/s", "pkts/s", "tick/s");
  const int only = argc > 3 ? std::atoi(argv[3]) : 0;
  for (const Setup& setup : setups) {
    if (only != 0 && &setup != &setups.at(static_cast<std::size_t>(only - 1))) continue;
    Effort effort;
    for (int seed = 1; seed <= missions; ++seed) run_one(setup, seed, duration_s, effort);
    print(setup, effort, missions);
  }
  return 0;
}
