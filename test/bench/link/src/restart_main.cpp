// SPDX-License-Identifier: Apache-2.0
// How long after a kill -9 of a host's router samples cross the link again: the mission's processes
// over the emulated radio, standing still, and peers on both hosts that write 200 samples a second.
// usage: link_restart [KILLS]
#include <fmt/format.h>

#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "foundation/whole_number.hpp"
#include "measure.hpp"

namespace {

using namespace tocsin;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// A real launcher waits longer before each further restart within a minute.
const char* const restarts = "restart: {backoff_s: 0.01, max_backoff_s: 0.01, limit: 1000}\n";

/// Of the kills of one router.
struct Recoveries {
  bench::Series up;
  bench::Series down;
  void add(const Recovery& one) {
    up.add(static_cast<std::int64_t>(1e9 * one.up_s));
    down.add(static_cast<std::int64_t>(1e9 * one.down_s));
  }
};

struct Times : std::map<std::string, Recoveries> {
  Times() : map{{"uxv/link", {}}, {"gcs/link", {}}} {}
};

std::string row(const std::string& name, const bench::Series& times) {
  const auto at = [&](double share) { return 1e-6 * times.percentile(share); };
  return fmt::format("{:<36} {:8.0f} {:8.0f} {:8.0f}\n", name, at(0.5), at(0.9), at(1));
}

void wait_for(const Stack& stack, const std::function<bool()>& condition) {
  if (!Stack::eventually(seconds(30), condition)) throw std::runtime_error(stack.output());
}

/// Throws std::runtime_error when samples do not cross again.
Times kill_each_in_turn(const Stack& stack, const Crossings& crossings, int kills) {
  Times times;
  std::mt19937 random(1);
  for (int i = 0; i < kills; ++i) {
    for (auto& [router, all] : times) {
      // Far enough from the one before, and at any phase of what is periodic.
      std::this_thread::sleep_for(milliseconds(3000 + random() % 2000));
      const auto time = kill_and_time(stack, router, crossings);
      if (!time) throw std::runtime_error(router + " does not carry again\n" + stack.output());
      all.add(*time);
      fmt::print(stderr, "{} killed at {:.4f} s, up {:.3f} s, down {:.3f} s\n", router,
                 1e-9 * static_cast<double>(time->killed_ns), time->up_s, time->down_s);
    }
  }
  return times;
}

void measure(int kills) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path(), restarts), "--seed", "1"});
  wait_for(stack, [&] { return stack.pid("uxv/link") != 0 && stack.pid("gcs/link") != 0; });
  const Crossings crossings(stack.pid("uxv/link"), stack.pid("gcs/link"), standing_domain);
  wait_for(stack, [&] {
    return crossings.first_after(Crossings::Way::up, 0) &&
           crossings.first_after(Crossings::Way::down, 0);
  });
  const Times times = kill_each_in_turn(stack, crossings, kills);
  fmt::print("{} kills each; crossing again after [ms]  median p90 max\n", kills);
  for (const auto& [router, all] : times) {
    fmt::print("{}{}", row(router + " killed, from the vehicle", all.up),
               row(router + " killed, to the vehicle", all.down));
  }
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("link_restart", [&] {
    measure(argc > 1 ? static_cast<int>(whole_number(argv[1], "KILLS", 1, 10000)) : 20);
    return 0;
  });
}
