// SPDX-License-Identifier: Apache-2.0
// What DDS Security costs on the link: the mission's processes over the emulated radio, standing
// still, in turns with and without it, and peers on both hosts that write 200 samples a second.
// usage: link_secured [TURNS [SECONDS]]
#include <fmt/format.h>
#include <array>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "foundation/whole_number.hpp"
#include "keystore/keystore.hpp"
#include "measure.hpp"

namespace {

using namespace tocsin;
using std::chrono::seconds;
using Way = Crossings::Way;

constexpr std::array<const char*, 2> routers{"uxv/link", "gcs/link"};
constexpr double written_per_s = 200;
constexpr double late_ms = 250;

/// Sums of all turns of one kind.
struct Figures {
  std::array<bench::Series, 2> crossing;
  double written = 0;
  double arrived = 0;
  double in_time = 0;
  double time_s = 0;
  std::array<double, 2> cpu_s{};

  void add(Way way, const Crossed& one) {
    const std::int64_t taken = one.received_ns - one.sent_ns;
    crossing[static_cast<std::size_t>(way)].add(taken);
    arrived += 1;
    if (1e-6 * static_cast<double>(taken) <= late_ms) in_time += 1;
  }
};

void wait_for(const Stack& stack, const std::function<bool()>& condition) {
  if (!Stack::eventually(seconds(60), condition)) throw std::runtime_error(stack.output());
}

void measure(const std::string& mission, const std::string& keystore, seconds time,
             Figures& figures) {
  std::vector<std::string> arguments{mission, "--seed", "1"};
  if (!keystore.empty()) arguments.insert(arguments.end(), {"--security", keystore});
  const Stack stack(arguments);
  wait_for(stack, [&] { return stack.pid(routers[0]) != 0 && stack.pid(routers[1]) != 0; });
  const Crossings crossings(stack.pid(routers[0]), stack.pid(routers[1]), standing_domain);
  wait_for(stack, [&] {
    return crossings.first_after(Way::up, 0) && crossings.first_after(Way::down, 0);
  });
  std::this_thread::sleep_for(seconds(5));
  const std::array<std::size_t, 2> before{crossings.all(Way::up).size(),
                                          crossings.all(Way::down).size()};
  std::array<double, 2> cpu{bench::cpu_s(stack.pid(routers[0])),
                            bench::cpu_s(stack.pid(routers[1]))};
  const std::int64_t begin = wall_now_ns();
  std::this_thread::sleep_for(time);
  for (std::size_t i = 0; i < cpu.size(); ++i) {
    figures.cpu_s[i] += bench::cpu_s(stack.pid(routers[i])) - cpu[i];
  }
  const double taken_s = 1e-9 * static_cast<double>(wall_now_ns() - begin);
  figures.time_s += taken_s;
  for (const Way way : {Way::up, Way::down}) {
    figures.written += written_per_s * taken_s;
    const auto all = crossings.all(way);
    for (std::size_t i = before[static_cast<std::size_t>(way)]; i < all.size(); ++i) {
      figures.add(way, all[i]);
    }
  }
}

void print(const char* name, const Figures& figures) {
  const auto ms = [&](Way way, double share) {
    return 1e-6 * figures.crossing[static_cast<std::size_t>(way)].percentile(share);
  };
  fmt::print("{:<8} from the vehicle {:5.2f} {:6.1f}, to it {:5.2f} {:6.1f} ms; ", name,
             ms(Way::up, 0.5), ms(Way::up, 0.99), ms(Way::down, 0.5), ms(Way::down, 0.99));
  fmt::print("lost {:.2f} %, lost or later than {:.0f} ms {:.2f} %; ",
             100 * (1 - figures.arrived / figures.written), late_ms,
             100 * (1 - figures.in_time / figures.written));
  fmt::print("CPU of a core {:.2f} and {:.2f} %\n", 100 * figures.cpu_s[0] / figures.time_s,
             100 * figures.cpu_s[1] / figures.time_s);
}

void compare(int turns, seconds time) {
  const TemporaryFolder folder;
  const std::string store = folder.path("keystore");
  keystore::create(store, std::time(nullptr));
  for (const char* const name : {"uxv", "gcs"}) {
    keystore::add(store, {name, {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
  }
  const std::string mission = standing_mission(folder.path());
  Figures plain;
  Figures secured;
  for (int i = 0; i < turns; ++i) {
    measure(mission, "", time, plain);
    measure(mission, store, time, secured);
  }
  fmt::print("{} turns of {} s each; from write to read: median, 99th percentile; uxv, gcs link\n",
             turns, time.count());
  print("plain", plain);
  print("secured", secured);
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("link_secured", [&] {
    compare(argc > 1 ? static_cast<int>(whole_number(argv[1], "TURNS", 1, 1000)) : 3,
            std::chrono::seconds(argc > 2 ? whole_number(argv[2], "SECONDS", 1, 86400) : 20));
    return 0;
  });
}
