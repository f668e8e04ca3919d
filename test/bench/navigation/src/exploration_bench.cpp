// SPDX-License-Identifier: Apache-2.0
// exploration_bench [--worlds N]: drives through random buildings that nobody has seen: whether
// they end by themselves, how much is known then, how long the way is, what a choice costs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "command_line/command.hpp"
#include "exploration_run.hpp"

namespace tocsin::bench {
namespace {

template <class Value>
double mean_of(const std::vector<ExplorationRun>& runs, const Value& value) {
  double sum = 0;
  for (const ExplorationRun& run : runs) sum += static_cast<double>(value(run));
  return sum / static_cast<double>(std::max<std::size_t>(1, runs.size()));
}

double worst_share(const std::vector<ExplorationRun>& runs) {
  double worst = 1;
  for (const ExplorationRun& run : runs) worst = std::min(worst, run.share_known);
  return worst;
}

void print_row(const char* kind, double failing, const std::vector<ExplorationRun>& runs) {
  const auto count = [&](const auto& predicate) {
    return std::count_if(runs.begin(), runs.end(), predicate);
  };
  fmt::print(
      "| {}, {:.0f} % of goals fail | {} | {} | {:.2f} | {:.2f} | {} | {:.0f} | {:.1f} | {} |\n",
      kind, 100 * failing, runs.size(),
      count([](const ExplorationRun& run) { return run.has_ended; }),
      100 * mean_of(runs, [](const ExplorationRun& run) { return run.share_known; }),
      100 * worst_share(runs),
      count([](const ExplorationRun& run) { return run.share_known < 0.99; }),
      mean_of(runs, [](const ExplorationRun& run) { return run.path_m; }),
      mean_of(runs, [](const ExplorationRun& run) { return run.goals; }),
      std::accumulate(runs.begin(), runs.end(), 0,
                      [](int sum, const ExplorationRun& run) { return sum + run.bumps; }));
  std::fflush(stdout);
}

void print_times(std::vector<double> times) {
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  fmt::print("\nA choice: {:.1f} ms mean, {:.1f} ms p99, of {}.\n",
             sum / static_cast<double>(times.size()), times[times.size() * 99 / 100], times.size());
}

int run(int worlds, std::uint64_t seed) {
  fmt::print(
      "| buildings | runs | ended by themselves | known, % mean | worst | below 99 % | way, m | "
      "goals "
      "| bumps |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::vector<double> times;
  for (const double failing : {0.0, 0.3}) {
    for (const WorldKind kind : {WorldKind::rooms, WorldKind::corridor, WorldKind::clutter}) {
      std::vector<ExplorationRun> runs;
      for (int i = 0; i < worlds / (failing > 0 ? 15 : 3); ++i) {
        const std::uint64_t its_seed = seed + static_cast<std::uint64_t>(i);
        runs.push_back(explore(random_world(kind, its_seed), failing, its_seed));
        auto& own = runs.back().choices_ms;
        times.insert(times.end(), own.begin(), own.end());
        own.clear();
      }
      print_row(to_string(kind), failing, runs);
    }
  }
  print_times(std::move(times));
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  int worlds = 1002;
  std::uint64_t seed = 1;
  CLI::App app("Exploration of random buildings with a simulated laser.");
  app.name("exploration_bench");
  app.add_option("--worlds", worlds,
                 "buildings of three kinds, and a fifth of them with goals that fail [1002]")
      ->check(CLI::Range(3, 1000000));
  app.add_option("--seed", seed, "of the first building of each kind [1]");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(worlds, seed); });
}
