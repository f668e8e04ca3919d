// SPDX-License-Identifier: Apache-2.0
// How long the wheels turn after a press of the emergency stop at the ground station, many times
// under each of many conditions. See README.md of this folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/program.hpp"
#include "stop_troubles.hpp"

namespace {

using namespace tocsin;
using std::chrono::seconds;

struct Plan {
  int times = 50;
  StopSiteOptions site;
  std::string only;
  /// [s] a press must have stopped the wheels.
  [[nodiscard]] double limit_s() const { return site.loses ? 2 : 0.5; }
};

struct Figures {
  std::vector<double> times_s;
  int never = 0;
  int not_released = 0;
};

/// For a person to look at.
void keep(StopSite& site, const Condition& condition, std::optional<double> time_s) {
  const auto end = std::chrono::system_clock::now().time_since_epoch();
  fmt::print("{}: {} at {:.3f}, see {}\n", condition.name,
             time_s ? fmt::format("at rest after {:.3f} s", *time_s) : "not at rest",
             std::chrono::duration<double>(end).count(), site.stack().folder());
  std::fflush(stdout);
  site.stack().keep();
}

/// The vehicle drives before each press: where it stands by a silent router, once that is received.
Figures press(const Plan& plan, const Condition& condition, StopSite& site) {
  Figures figures;
  std::shared_ptr<void> trouble;
  if (condition.lasts) trouble = condition.trouble(site);
  for (int i = 0; i < plan.times; ++i) {
    if (!condition.lasts) trouble = condition.trouble(site);
    if (!site.moves(seconds(20))) ++figures.not_released;
    const auto time_s = site.press();
    if (!time_s || *time_s > plan.limit_s()) keep(site, condition, time_s);
    if (time_s) figures.times_s.push_back(*time_s);
    if (!time_s) ++figures.never;
    if (!site.release()) ++figures.not_released;
  }
  std::sort(figures.times_s.begin(), figures.times_s.end());
  return figures;
}

Figures run(const Plan& plan, const Condition& condition) {
  StopSiteOptions options = plan.site;
  options.disk_mib = condition.disk_mib;
  StopSite site(options);
  try {
    return press(plan, condition, site);
  } catch (const std::exception&) {
    fmt::print("{}: see {}\n", condition.name, site.stack().folder());
    std::fflush(stdout);
    site.stack().keep();
    throw;
  }
}

/// Prints a line; whether each press stopped the wheels in time.
bool tell(const Condition& condition, const Figures& figures, double limit_s) {
  const auto& times = figures.times_s;
  const auto in_time =
      std::count_if(times.begin(), times.end(), [&](double one) { return one <= limit_s; });
  const double median = times.empty() ? -1 : times[times.size() / 2];
  const double worst = times.empty() ? -1 : times.back();
  fmt::print("{:<32}{:>8}{:>10.3f}{:>10.3f}{:>12}{:>8}{:>10}\n", condition.name, times.size(),
             median, worst, in_time, figures.never, figures.not_released);
  std::fflush(stdout);
  return figures.never == 0 && in_time == static_cast<std::ptrdiff_t>(times.size());
}

int campaign(const Plan& plan) {
  const double limit_s = plan.limit_s();
  fmt::print("wheels at rest after a press, {} times, {} link, {}; in time: {} s\n", plan.times,
             plan.site.secured ? "secured" : "plain", plan.site.loses ? "30 % loss" : "good",
             limit_s);
  fmt::print("{:<32}{:>8}{:>10}{:>10}{:>12}{:>8}{:>10}\n", "condition", "presses", "median s",
             "worst s", "in time", "never", "not freed");
  bool sound = true;
  for (const Condition& condition : conditions()) {
    if (condition.name.find(plan.only) == std::string::npos) continue;
    sound = tell(condition, run(plan, condition), limit_s) && sound;
  }
  return sound ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Plan plan;
  CLI::App app("How long wheels turn after a press of the emergency stop");
  app.add_option("--times", plan.times, "presses under each condition [50]");
  app.add_flag("--loss", plan.site.loses, "30 % of the packets are lost");
  app.add_flag("--secured", plan.site.secured, "a link with a keystore");
  app.add_option("--only", plan.only, "conditions with this text");
  CLI11_PARSE(app, argc, argv);
  return run_program("stop_campaign", [&] { return campaign(plan); });
}
