// SPDX-License-Identifier: Apache-2.0
// Mission B with stored topics over an outage of the emulated radio, in which routers, with their
// stores, and recorders are killed with -9. See README.md of this folder.
#include <fmt/format.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "stack.hpp"
#include "stored_topics.hpp"

namespace {

using namespace tocsin;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Clock = std::chrono::steady_clock;

struct Plan {
  int outage_s = 60;
  int before_s = 20;
  unsigned seed = 1;
  int missions = 1;
};

const std::vector<std::string> stored{"network_quality", "location", "battery_state",
                                      "memory_usage",    "cpu_load", "cpu_temperature"};
/// Killed in this order, at equal times of the outage.
const std::vector<std::string> killed{"uxv/link", "uxv/recorder", "gcs/link", "gcs/recorder",
                                      "uxv/link"};

std::string bringup(const TemporaryFolder& folder) {
  (void)folder.write("campaign_traffic.yaml",
                     "extends: traffic_store.yaml\n"
                     "uxv:\n  high: {keep: [network_quality, location]}\n"
                     "  low: {keep: [battery_state, memory_usage, cpu_load, cpu_temperature]}\n");
  return folder.write("campaign.yaml",
                      "extends: mission.yaml\n"
                      "traffic: campaign_traffic.yaml\n"
                      "stop_when_exits: ~\n"
                      "hosts: {gcs: {containers: [{view: ~}, {page: ~}]}}\n");
}

void kill_in_outage(const Stack& stack, int outage_s) {
  const auto begin = Clock::now();
  const auto step = milliseconds(1000 * outage_s) / static_cast<int>(killed.size() + 1);
  for (std::size_t i = 0; i < killed.size(); ++i) {
    std::this_thread::sleep_until(begin + step * static_cast<int>(i + 1));
    const pid_t pid = stack.pid(killed[i]);
    if (pid != 0) ::kill(pid, SIGKILL);
    fmt::print("  kill -9 {}{}\n", killed[i], pid == 0 ? ": it does not run" : "");
    std::fflush(stdout);
  }
  std::this_thread::sleep_until(begin + seconds(outage_s));
}

std::vector<StoredTopicFigures> figures(const Stack& stack, const StationReaders& readers,
                                        std::int64_t end_ns) {
  const auto got = readers.got();
  std::vector<StoredTopicFigures> all;
  for (std::uint32_t i = 0; i < stored.size(); ++i) {
    const BothLogs logs{logged_in(stack.path("uxv/store"), stored[i]),
                        logged_in(stack.path("gcs/store/history"), stored[i])};
    all.push_back(figures_of(i, logs, got, end_ns));
  }
  return all;
}

/// Prints them; whether each sample came and was heard, none twice, in order.
bool tell(const std::vector<StoredTopicFigures>& all, std::int64_t end_ns) {
  bool sound = true;
  fmt::print("  {:<18}{:>8}{:>10}{:>8}{:>11}{:>9}{:>9}{:>7}{:>12}{:>12}\n", "topic", "logged",
             "unrouted", "live", "backfilled", "missing", "unheard", "twice", "disordered",
             "complete");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const StoredTopicFigures& one = all[i];
    fmt::print("  {:<18}{:>8}{:>10}{:>8}{:>11}{:>9}{:>9}{:>7}{:>12}{:>10.1f} s\n", stored[i],
               one.logged, one.unrouted, one.live, one.backfilled, one.missing, one.unheard,
               one.twice, one.disordered, static_cast<double>(one.last_ns - end_ns) * 1e-9);
    sound = sound && one.logged > 0 && one.missing == 0 && one.unheard == 0 && one.twice == 0 &&
            one.disordered == 0;
  }
  std::fflush(stdout);
  return sound;
}

bool run_mission(const Plan& plan, unsigned seed) {
  const TemporaryFolder folder;
  Stack stack({bringup(folder), "--seed", std::to_string(seed), "--channel",
               Stack::share("config/radio/classroom_mission_b.yaml"), "--set",
               "transmission_controller.policy=tocp_dsp", "--set",
               "mission_control.mission_file=" + Stack::share("config/missions/mission_b.yaml")});
  if (!Stack::eventually(seconds(90), [&] { return is_driving(stack); })) {
    fmt::print("mission with seed {} does not drive\n{}\n", seed, stack.output());
    return false;
  }
  const StationReaders readers(stack.running("gcs/link"), standing_domain + 1,
                               Stack::share("config/qos.yaml"), stored);
  std::this_thread::sleep_for(seconds(plan.before_s));
  stack.control("radio.sock", fmt::format("set outage {}", plan.outage_s));
  kill_in_outage(stack, plan.outage_s);
  const std::int64_t end_ns = wall_now_ns();
  const auto complete = [&] {
    const auto all = figures(stack, readers, end_ns);
    return std::all_of(all.begin(), all.end(), [](const auto& one) { return one.missing == 0; });
  };
  const bool in_time = Stack::eventually(seconds(2 * plan.outage_s), complete);
  const bool sound = tell(figures(stack, readers, end_ns), end_ns) && in_time;
  fmt::print("mission B with seed {}: {}\n", seed,
             sound ? fmt::format("all there within {} s of an outage of {} s", 2 * plan.outage_s,
                                 plan.outage_s)
                   : "NOT all there once, in order and in time");
  if (!sound) stack.keep();
  std::fflush(stdout);
  return sound;
}

}  // namespace

int main(int argc, char** argv) {
  Plan plan;
  CLI::App app("Stored topics of Mission B over an outage with kill -9");
  app.add_option("--outage", plan.outage_s, "[s] [60]")->check(CLI::Range(6, 600));
  app.add_option("--before", plan.before_s, "[s] of driving before it [20]");
  app.add_option("--seed", plan.seed, "of the first mission; each has the next [1]");
  app.add_option("--missions", plan.missions, "one after the other [1]");
  CLI11_PARSE(app, argc, argv);
  return run_program("store_campaign", [&] {
    int sound = 0;
    for (int i = 0; i < plan.missions; ++i) {
      if (run_mission(plan, plan.seed + static_cast<unsigned>(i))) ++sound;
    }
    fmt::print("{} of {} missions lost nothing\n", sound, plan.missions);
    return sound == plan.missions ? 0 : 1;
  });
}
