// SPDX-License-Identifier: Apache-2.0
// How fast the main job runs in simulated time, with and without its parts, and a run of the
// thesis's experiment as `tocsin experiment run` does it.
// usage: simulation_speed [MISSIONS [SECONDS [ROW]]]   missions with seeds 1.. (default 5), each of
// so many simulated seconds (0: until it is over; runs of the experiment take 600), all rows or
// one. CPU time of one thread.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "foundation/thread_cpu.hpp"
#include "foundation/yaml_file.hpp"
#include "simulation/sim_world.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tocsin;

struct Setup {
  const char* name;
  std::vector<std::string> without;  // components
  bool digest;
  std::vector<std::string> set;
  int experiment_mission = -1;  // place in thesis.yaml; else mission A of the bringup
};

/// What the experiment looks at while it runs.
struct Listening final : simulation::Observer {
  void on_written(const simulation::Written& written) override { bytes += written.bytes; }
  void on_delivered(const simulation::Delivered& delivered) override { bytes += delivered.bytes; }
  std::size_t bytes = 0;
};

struct Effort {
  double load_s = 0;
  double build_s = 0;
  double run_s = 0;
  double simulated_s = 0;
  simulation::Outcome last;
};

double cpu_s() { return to_seconds(thread_cpu()); }

/// Mission, settings, channel and what is left out, as thesis.yaml says.
void set_experiment(const Setup& setup, deployment::Overrides& overrides) {
  const std::string folder = overrides.share + "/config/experiments/";
  const YAML::Node file = read_yaml_file(folder + "thesis.yaml");
  const YAML::Node mission = file["missions"][setup.experiment_mission];
  const auto name = mission["name"].as<std::string>();
  for (const auto& one : mission["set"]) overrides.set.push_back(one.as<std::string>());
  overrides.set.push_back("mission_control.mission_file=" + folder +
                          mission["file"].as<std::string>());
  auto channel = file["channels"][0]["file"].as<std::string>();
  channel.replace(channel.find("${mission}"), 10, name);
  overrides.channel = folder + channel;
  overrides.without = {"gcs/view"};
}

/// In place of a recorder the experiment only listens.
void put_listeners(deployment::Deployment& deployment) {
  for (auto& host : deployment.hosts) {
    for (auto& container : host.containers) {
      for (auto& one : container.components) {
        if (one.component != "recorder") continue;
        one.component = "experiment";
        one.parameters = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
      }
    }
  }
}

deployment::Deployment load(const Setup& setup, int seed, const fs::path& run_dir) {
  const fs::path share =
      fs::read_symlink("/proc/self/exe").parent_path() / "../../bringup/share/tocsin";
  deployment::Overrides overrides;
  overrides.share = fs::canonical(share).string();
  overrides.run_dir = run_dir.string();
  overrides.seed = seed;
  overrides.set = setup.set;
  const bool experiment = setup.experiment_mission >= 0;
  if (experiment) set_experiment(setup, overrides);
  auto deployment = load_deployment(overrides.share + "/bringup/mission.yaml", overrides);
  if (experiment) put_listeners(deployment);
  return deployment;
}

void run_one(const Setup& setup, int seed, double duration_s, Effort& effort) {
  const fs::path run_dir = fs::temp_directory_path() / ("sim_speed_" + std::to_string(::getpid()));
  fs::remove_all(run_dir);
  fs::create_directory(run_dir);
  const bool experiment = setup.experiment_mission >= 0;
  if (experiment && duration_s <= 0) duration_s = 600;
  const double start = cpu_s();
  const auto deployment = load(setup, seed, run_dir);
  const double loaded = cpu_s();
  Listening listening;
  simulation::WorldOptions options;
  options.digest = setup.digest;
  options.without = setup.without;
  options.ends_with_mission = experiment || duration_s <= 0;
  if (experiment) options.observer = &listening;
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
      {"thesis's experiment with camera, mission A", {}, false, {}, 0},
      {"thesis's experiment with camera, mission B", {}, false, {}, 1},
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
