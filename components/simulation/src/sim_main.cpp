// SPDX-License-Identifier: Apache-2.0
#include <time.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <future>

#include "deployment/deployment.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "simulation/sim_world.hpp"

namespace tocsin::simulation {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file;
  deployment::Overrides overrides;
  double duration_s = 3600;
  bool verify = false;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("FILE", options.file, "bringup file; a bare name is also looked for in the share")
      ->required();
  app.add_option("--seed", options.overrides.seed, "value of ${seed}; decides everything random")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--set", options.overrides.set, "parameter of a component: name.key=value")
      ->expected(1)
      ->take_all();
  app.add_option("--without", options.overrides.without, "host/process that is left out")
      ->expected(1)
      ->take_all();
  app.add_option("--channel", options.overrides.channel,
                 "channel file of the radio, in place of the file's");
  app.add_option("--duration", options.duration_s, "[s] end here unless the mission is over before")
      ->check(CLI::Range(0.001, 1e9))
      ->capture_default_str();
  app.add_flag("--verify", options.verify,
               "run twice, on two threads; exit code 1 unless both write the same samples");
  app.add_option("--run-dir", options.overrides.run_dir,
                 "folder of the run, new or empty [runs/sim_<UTC time>]");
}

/// bringup's share folder, installed in one folder with this program or in one per package.
fs::path share_folder() {
  const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
  const fs::path together = prefix / "share/tocsin";
  return fs::is_directory(together) ? together : prefix.parent_path() / "bringup/share/tocsin";
}

std::string locate(const std::string& file, const fs::path& share) {
  const bool bare = file.find('/') == std::string::npos && !fs::exists(file);
  const fs::path shared = share / "bringup" / file;
  return bare && fs::exists(shared) ? shared.string() : file;
}

/// Recorders append, so an old folder would mix two runs.
std::string make_run_folder(const std::string& wanted) {
  char stamp[40];
  const std::time_t now = std::time(nullptr);
  std::strftime(stamp, sizeof stamp, "runs/sim_%Y%m%dT%H%M%SZ", std::gmtime(&now));
  const fs::path folder = fs::absolute(wanted.empty() ? stamp : wanted).lexically_normal();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw EnvironmentError(folder.string() + ": cannot be made: " + error.message());
  if (!fs::is_empty(folder)) throw ConfigError("--run-dir " + folder.string() + ": is not empty");
  return folder;
}

double thread_cpu_s() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// How long a run took.
struct Effort {
  double wall_s;
  double cpu_s;
};

void print(const Outcome& outcome, const Effort& effort, const std::string& run_dir) {
  const double simulated_s = to_seconds(outcome.simulated);
  const std::string end = outcome.exit_code ? "exit code " + std::to_string(*outcome.exit_code)
                                            : std::string("not over");
  std::printf(
      "%.3f s simulated (%s) in %.3f s (CPU %.3f s), %.0f times real time; %llu samples, %llu "
      "packets, "
      "%llu ticks; digest %016llx; %s\n",
      simulated_s, end.c_str(), effort.wall_s, effort.cpu_s, simulated_s / effort.wall_s,
      static_cast<unsigned long long>(outcome.samples),
      static_cast<unsigned long long>(outcome.packets),
      static_cast<unsigned long long>(outcome.ticks),
      static_cast<unsigned long long>(outcome.digest), run_dir.c_str());
}

Outcome simulate(const Options& options, const std::string& run_dir) {
  deployment::Overrides overrides = options.overrides;
  overrides.run_dir = make_run_folder(run_dir);
  const auto deployment = deployment::load_deployment(options.file, overrides);
  deployment::write_resolved(deployment, overrides.run_dir + "/deployment.yaml");
  SimWorld world(deployment);
  const auto begin = std::chrono::steady_clock::now();
  const double cpu_begin_s = thread_cpu_s();
  const Outcome outcome = world.run(seconds(options.duration_s));
  const auto wall = std::chrono::steady_clock::now() - begin;
  print(outcome, {to_seconds(Duration(wall)), thread_cpu_s() - cpu_begin_s}, overrides.run_dir);
  return outcome;
}

int simulate(Options& options) {
  deployment::Overrides& overrides = options.overrides;
  overrides.share = share_folder().string();
  options.file = locate(options.file, overrides.share);
  // Checked before the folder of the run is made: a wrong file leaves nothing behind.
  (void)deployment::load_deployment(options.file, overrides);
  const std::string run_dir = make_run_folder(overrides.run_dir);
  if (!options.verify) return simulate(options, run_dir).exit_code.value_or(0);
  const auto run = [&](const char* name) { return simulate(options, run_dir + name); };
  auto second = std::async(std::launch::async, run, "/second");
  const Outcome first = run("/first");
  if (first.digest == second.get().digest) return 0;
  throw EnvironmentError("two runs with the same seed differ");
}

int body(int argc, char** argv) {
  CLI::App app{"Run a bringup file in simulated time, faster than real time and repeatable"};
  app.name("tocsin sim");
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    throw ConfigError(error.what());
  }
  return simulate(options);
}

}  // namespace
}  // namespace tocsin::simulation

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin sim", [&] { return tocsin::simulation::body(argc, argv); });
}
