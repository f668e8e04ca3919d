// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <fstream>
#include <future>

#include "deployment/run_folder.hpp"
#include "foundation/error.hpp"
#include "foundation/thread_cpu.hpp"
#include "sim_command.hpp"

namespace tocsin::simulation {
namespace {

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
      "packets, %llu ticks; digest %016llx; %s\n",
      simulated_s, end.c_str(), effort.wall_s, effort.cpu_s, simulated_s / effort.wall_s,
      static_cast<unsigned long long>(outcome.samples),
      static_cast<unsigned long long>(outcome.packets),
      static_cast<unsigned long long>(outcome.ticks),
      static_cast<unsigned long long>(outcome.digest), run_dir.c_str());
}

/// Prints the faults and leaves them in the folder, from where they can be played again.
void tell_faults(const FaultPlan& plan, const std::string& run_dir) {
  if (plan.empty()) return;
  const std::string text = to_yaml(plan);
  std::fputs(text.c_str(), stdout);
  std::ofstream file(run_dir + "/faults.yaml");
  file << text;
  if (!file.flush()) throw EnvironmentError(run_dir + "/faults.yaml: cannot be written");
}

/// A run and whether it kept the promises, if that was asked for.
SeedOutcome run(const Options& options, deployment::Deployment deployment) {
  WorldOptions world;
  world.faults = faults_of(options, deployment);
  tell_faults(world.faults, deployment.run_dir);
  if (options.check) return run_checked(deployment, world, options.limits);
  SeedOutcome checked;
  checked.outcome = SimWorld(std::move(deployment), world).run(seconds(options.duration_s));
  return checked;
}

SeedOutcome simulate_into(const Options& options, const deployment::RunFolder& run_folder) {
  deployment::Overrides overrides = options.overrides;
  overrides.run_dir = run_folder.path().string();
  auto deployment = deployment::load_deployment(options.file, overrides);
  deployment::write_resolved(deployment, overrides.run_dir + "/deployment.yaml");
  deployment::write_parts(deployment);
  const auto begin = std::chrono::steady_clock::now();
  const Duration cpu_begin = thread_cpu();
  SeedOutcome checked = run(options, std::move(deployment));
  const auto wall = std::chrono::steady_clock::now() - begin;
  print(checked.outcome, {to_seconds(Duration(wall)), to_seconds(thread_cpu() - cpu_begin)},
        overrides.run_dir);
  return checked;
}

/// 1 when a promise was broken.
int judge(const SeedOutcome& checked) {
  std::fputs(to_text(checked).c_str(), stdout);
  std::printf("%llu checks, %zu promises broken\n", static_cast<unsigned long long>(checked.checks),
              checked.violations.size());
  return checked.violations.empty() ? 0 : 1;
}

}  // namespace

FaultPlan faults_of(const Options& options, const deployment::Deployment& deployment) {
  if (options.faults.empty()) return {};
  if (options.faults != "random") return load_faults(options.faults);
  return random_faults(static_cast<std::uint64_t>(deployment.seed), deployment);
}

int simulate(const Options& options) {
  // Checked before the folder of the run is made: a wrong file leaves nothing behind.
  (void)faults_of(options, deployment::load_deployment(options.file, options.overrides));
  const deployment::RunFolder folder(options.overrides.run_dir, "runs/sim_");
  if (!options.verify) {
    const SeedOutcome checked = simulate_into(options, folder);
    return options.check ? judge(checked) : checked.outcome.exit_code.value_or(0);
  }
  const auto run_in = [&](const char* name) {
    return simulate_into(options, deployment::RunFolder(folder.path() / name));
  };
  auto second = std::async(std::launch::async, run_in, "second");
  const Outcome first = run_in("first").outcome;
  if (first.digest == second.get().outcome.digest) return 0;
  throw EnvironmentError("two runs with the same seed differ");
}

}  // namespace tocsin::simulation
