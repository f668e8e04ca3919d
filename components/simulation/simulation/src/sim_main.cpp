// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <thread>

#include "command_line/command.hpp"
#include "runtime/middleware/component_library.hpp"
#include "sim_command.hpp"

namespace tocsin::simulation {
namespace {

void declare_run(CLI::App& app, Options& options) {
  options.declare(app);
  app.add_option("--duration", options.duration_s, "[s] end here unless the mission is over before")
      ->check(CLI::Range(0.001, 1e9))
      ->capture_default_str();
  app.add_flag("--verify", options.verify,
               "run twice, on two threads; exit code 1 unless both write the same samples");
  app.add_option("--run-dir", options.overrides.run_dir,
                 "folder of the run, new or empty [runs/sim_<UTC time>]");
}

void declare_faults(CLI::App& app, Options& options) {
  app.add_option("--faults", options.faults, "'random' from the seed, or a file of faults");
  app.add_flag("--check", options.check,
               "check the promises after every event until the mission is over; exit code 1 for a "
               "broken one");
  app.add_option("--over-within", options.limits.recovers_s,
                 "[s] of the last fault the mission must be over, which a check is the end of")
      ->check(CLI::Range(1.0, 86400.0))
      ->capture_default_str();
  auto* seeds =
      app.add_option("--seeds", options.seeds, "A..B: check these, print those that fail");
  auto* search = app.add_flag("--until-failure", options.until_failure,
                              "check seeds (1..1000) until one fails");
  app.add_option("--jobs", options.jobs, "runs side by side [cores]")->check(CLI::Range(1, 256));
  for (auto* many : {static_cast<CLI::Option*>(seeds), static_cast<CLI::Option*>(search)}) {
    many->excludes("--verify")->excludes("--run-dir")->excludes("--seed");
  }
}

/// The command without what chooses the seeds.
std::string replay_of(const Options& options, const std::string& file) {
  std::string words = "tocsin sim " + file;
  for (const std::string& set : options.overrides.set) words += " --set '" + set + "'";
  for (const std::string& one : options.overrides.without) words += " --without " + one;
  if (!options.overrides.channel.empty()) words += " --channel " + options.overrides.channel;
  if (!options.overrides.qos.empty()) words += " --qos " + options.overrides.qos;
  if (!options.overrides.traffic.empty()) words += " --traffic " + options.overrides.traffic;
  if (!options.faults.empty()) words += " --faults " + options.faults;
  if (options.limits.recovers_s != InvariantLimits{}.recovers_s) {
    words += " --over-within " + std::to_string(std::lround(options.limits.recovers_s));
  }
  return words;
}

int run(Options& options) {
  options.replay = replay_of(options, options.file);
  options.locate();
  options.overrides.installed = installed_component_names();
  const bool many = options.until_failure || !options.seeds.empty();
  return many ? search_seeds(options) : simulate(options);
}

}  // namespace
}  // namespace tocsin::simulation

int main(int argc, char** argv) {
  using namespace tocsin::simulation;
  CLI::App app{"Run a bringup file in simulated time, faster than real time and repeatable",
               "tocsin sim"};
  Options options;
  options.jobs = std::max(1U, std::thread::hardware_concurrency());
  declare_run(app, options);
  declare_faults(app, options);
  return tocsin::run_command(app, argc, argv, [&] { return run(options); });
}
