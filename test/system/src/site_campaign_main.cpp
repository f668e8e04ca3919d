// SPDX-License-Identifier: Apache-2.0
// Hand-overs of a vehicle between two sites. See README.md of this folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "foundation/program.hpp"
#include "site_rig.hpp"

namespace {

using namespace tocsin;

/// [s] The middle and the largest of some times.
void tell(const char* what, std::vector<double> times_s) {
  std::sort(times_s.begin(), times_s.end());
  const std::size_t over = static_cast<std::size_t>(
      std::count_if(times_s.begin(), times_s.end(), [](double one) { return one > 1; }));
  fmt::print("  {:<34}{:>8.2f} s{:>8.2f} s{:>10}\n", what, times_s[times_s.size() / 2],
             times_s.back(), over);
}

int run(int times) {
  SiteRig rig;
  if (!rig.runs()) {
    fmt::print("nothing crosses\n{}\n", rig.stack().output());
    return 1;
  }
  std::vector<double> up;
  std::vector<double> down;
  std::vector<double> back_up;
  std::vector<double> back_down;
  for (int i = 0; i < times; ++i) {
    const auto silence =
        rig.hand_over(i % 2 == 0 ? SiteRig::Trouble::freeze : SiteRig::Trouble::kill);
    if (!silence) {
      fmt::print("hand-over {} did not end\n{}\n", i + 1, rig.stack().output());
      return 1;
    }
    up.push_back(silence->up_s);
    down.push_back(silence->down_s);
    back_up.push_back(silence->back_up_s);
    back_down.push_back(silence->back_down_s);
  }
  const std::int64_t end_ns = wall_now_ns();
  const bool whole =
      Stack::eventually(std::chrono::seconds(120), [&] { return rig.stored(end_ns).missing == 0; });
  const SiteRig::Stored stored = rig.stored(end_ns);
  fmt::print("{} hand-overs and as many back; silence of class critical\n", times);
  fmt::print("  {:<34}{:>10}{:>10}{:>10}\n", "", "median", "largest", "above 1 s");
  tell("from the vehicle, to the other site", up);
  tell("to the vehicle, from the other site", down);
  tell("from the vehicle, and back", back_up);
  tell("to the vehicle, and back", back_down);
  fmt::print("stored samples: {} logged, {} at no site, {} at both, {} twice at one\n",
             stored.logged, stored.missing, stored.both, stored.twice);
  return whole && stored.twice == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  int times = 10;
  CLI::App app("Hand-overs of a vehicle between two sites, whose routers are frozen and killed");
  app.add_option("--times", times, "hand-overs, each with one back [10]")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  return run_program("site_campaign", [&] { return run(times); });
}
