// SPDX-License-Identifier: Apache-2.0
// Real missions, one after the other, with faults drawn from a seed until the mission is over or
// has had enough of them; each must be completed. See README.md of this folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <thread>

#include "foundation/program.hpp"
#include "real_faults.hpp"

namespace {

using namespace tocsin;
using std::chrono::seconds;
using Clock = std::chrono::steady_clock;

constexpr int disk_mib = 64;
constexpr auto longest_after_faults = seconds(300);

struct Plan {
  int minutes = 60;
  unsigned seed = 1;
  int faults = 6;  ///< of a mission
};

struct Figures {
  int missions = 0;
  int completed = 0;
  int restarts = 0;
  std::map<std::string, int> faults;
};

int count(const std::string& text, const std::string& word) {
  int found = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Whether the mission was completed.
bool run_mission(const Plan& plan, unsigned seed, Figures& figures) {
  std::mt19937 random(seed);
  Stack stack({"mission.yaml", "--seed", std::to_string(seed)}, disk_mib);
  bool sound = Stack::eventually(seconds(60), [&] { return is_driving(stack); });
  for (int i = 0; sound && i < plan.faults && !stack.processes().empty(); ++i) {
    std::this_thread::sleep_for(seconds(1 + random() % 5));
    const PlannedFault planned = draw_fault(random, stack.processes());
    fmt::print("  {}\n", to_text(planned));
    std::fflush(stdout);
    const auto failure = inflict(stack, planned);
    if (failure) fmt::print("  {}\n", *failure);
    ++figures.faults[words_of(planned.fault)[static_cast<std::size_t>(planned.fault)]];
  }
  const int code = stack.exit_code(longest_after_faults);
  figures.restarts += count(stack.output(), ", restarting");
  sound = sound && code == 0;
  fmt::print("mission with seed {}: {}\n", seed,
             sound ? "completed" : fmt::format("NOT completed, exit code {}", code));
  if (!sound) {
    stack.keep();
    fmt::print("{}\nkept in {}\n", stack.output(), stack.folder());
  }
  std::fflush(stdout);
  return sound;
}

int soak(const Plan& plan) {
  Figures figures;
  const auto end = Clock::now() + std::chrono::minutes(plan.minutes);
  while (Clock::now() < end) {
    const auto number = static_cast<unsigned>(figures.missions++);
    if (run_mission(plan, plan.seed + number, figures)) ++figures.completed;
  }
  fmt::print("{} of {} missions completed, {} restarts; faults:", figures.completed,
             figures.missions, figures.restarts);
  for (const auto& [fault, times] : figures.faults) fmt::print(" {} {}", fault, times);
  fmt::print("\n");
  return figures.completed == figures.missions ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Plan plan;
  CLI::App app("Real missions with random faults");
  app.add_option("--minutes", plan.minutes, "begins no mission after that [60]");
  app.add_option("--seed", plan.seed, "of the first mission; each has the next [1]");
  app.add_option("--faults", plan.faults, "of a mission [6]");
  CLI11_PARSE(app, argc, argv);
  return run_program("mission_soak", [&] { return soak(plan); });
}
