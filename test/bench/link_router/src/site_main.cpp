// SPDX-License-Identifier: Apache-2.0
// What vehicles on one channel do to each other, and what shares of its air are worth: each sends
// what is urgent, and bulk without end; the last one stands far away. The rival of airtime shares
// are shares that give all the same bytes, in as much of the air. usage: site [SECONDS [AIR [AIR]]]
// AIR: of the channel, that the shares are of, without 802.11e and with it; 0.4 and 0.85.
// Of the vehicles that stand near: delay of critical samples of both ways, what of them is lost or
// later than 250 ms, and bulk. *w/o*: of its critical p99 without the far one.
//
// Then whether it pays the others when a vehicle holds its bulk where it stands badly: it drives to
// and fro for two minutes each, takes 40 kB of pictures a second, and keeps those that do not go at
// once. It knows its way, so no policy gains more. *hold over send*: bulk of the others, and their
// critical p99, where it holds them beyond 100 m, over where it sends always; means of five seeds
// with 95 % intervals.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "foundation/program.hpp"
#include "site_run.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

constexpr std::size_t sizes[] = {2, 5, 10, 20};

void print(SiteRun run, const char* name) {
  const SiteFigures with = figures_of(run);
  run.last = false;
  const SiteFigures without = figures_of(run);
  const auto near = static_cast<double>(run.near);
  std::printf("| %zu | %s | %.1f | %.1f | %.2f | %.2f | %.0f | %.0f | %.0f |\n", run.near + 1, name,
              with.p50_ms, with.p99_ms, with.p99_ms / without.p99_ms, with.late, with.near_kb_per_s,
              with.last_kb_per_s, with.near_kb_per_s * near + with.last_kb_per_s);
  std::fflush(stdout);
}

void print_divisions(SiteRun run) {
  std::printf("%s 802.11e\n\n", run.access_categories ? "with" : "without");
  std::printf(
      "| vehicles | shares | p50, ms | p99, ms | w/o | late, %% | near, kB/s each | far, kB/s | "
      "all, kB/s |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::size_t vehicles : sizes) {
    run.near = vehicles - 1;
    run.division = Division::none;
    print(run, "none");
    run.division = Division::equal_bytes;
    print(run, "equal bytes");
    run.division = Division::airtime;
    print(run, "airtime");
  }
  std::printf("\n");
}

/// [m] From 4 m to 200 m and back.
double to_and_fro(double t_s) {
  const double turn = std::fmod(t_s, 120) / 60;
  return 4 + 196 * (turn < 1 ? turn : 2 - turn);
}

/// Mean and half of its 95 % interval.
struct Mean {
  explicit Mean(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    for (const double one : values) mean += one / n;
    double squares = 0;
    for (const double one : values) squares += std::pow(one - mean, 2);
    constexpr double student = 2.776;  // of four degrees of freedom, 0.975
    half = student * std::sqrt(squares / (n - 1) / n);
  }
  double mean = 0;
  double half = 0;
};

void print_holding(SiteRun run) {
  run.division = Division::airtime;
  run.last_x_m = to_and_fro;
  run.last_pictures_per_s = 4.0 / 3;
  std::vector<double> bulk;
  std::vector<double> p99;
  std::vector<double> own;
  for (run.seed = 1; run.seed <= 5; ++run.seed) {
    run.last_may_send = [](double) { return true; };
    const SiteFigures sends = figures_of(run);
    run.last_may_send = [](double t_s) { return to_and_fro(t_s) < 100; };
    const SiteFigures holds = figures_of(run);
    bulk.push_back(holds.near_kb_per_s / sends.near_kb_per_s);
    p99.push_back(holds.p99_ms / sends.p99_ms);
    own.push_back(holds.last_kb_per_s / sends.last_kb_per_s);
  }
  std::printf("| %zu | %s | %.3f +-%.3f | %.3f +-%.3f | %.3f |\n", run.near + 1,
              run.access_categories ? "yes" : "no", Mean(bulk).mean, Mean(bulk).half,
              Mean(p99).mean, Mean(p99).half, Mean(own).mean);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("site", [&] {
    SiteRun run;
    if (argc > 1) run.length_s = std::stod(argv[1]);
    const double air[] = {argc > 2 ? std::stod(argv[2]) : 0.4,
                          argc > 3 ? std::stod(argv[3]) : 0.85};
    for (const bool access_categories : {false, true}) {
      run.access_categories = access_categories;
      run.shares.air = air[access_categories ? 1 : 0];
      print_divisions(run);
    }
    std::printf(
        "| vehicles | 802.11e | hold over send: bulk of the others | their critical p99 | its own "
        "bulk |\n| --- | --- | --- | --- | --- |\n");
    run.length_s = 4 * run.length_s;
    for (const bool access_categories : {false, true}) {
      run.access_categories = access_categories;
      run.shares.air = air[access_categories ? 1 : 0];
      for (const std::size_t vehicles : sizes) {
        run.near = vehicles - 1;
        print_holding(run);
      }
    }
    return 0;
  });
}
