// SPDX-License-Identifier: Apache-2.0
// CPU of the driver at 50 frames a second, and time from the write of a frame's last bytes to the
// write of its odometry, with all topics on Fast DDS; beside it a bare poll and read loop on the
// same kind of terminal. usage: kobuki_driver_cost [SECONDS] from the repository's root
#include <fcntl.h>
#include <poll.h>
#include <time.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "feeder.hpp"
#include "foundation/error.hpp"
#include "measure.hpp"
#include "odom_watch.hpp"
#include "runtime/middleware/component_library.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::bench {
namespace {

double clock_s(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Result {
  Series latency;
  double thread_share = 0;   ///< of a core, the thread that reads
  double process_share = 0;  ///< all threads, the feeder's too
};

/// Calls `once(until)` again and again for `duration_s` and measures what it takes.
template <class Once>
void run(double duration_s, Result& result, const Once& once) {
  const double thread = clock_s(CLOCK_THREAD_CPUTIME_ID);
  const double process = clock_s(CLOCK_PROCESS_CPUTIME_ID);
  result.latency = {};
  const std::int64_t end = now_ns() + static_cast<std::int64_t>(1e9 * duration_s);
  while (now_ns() < end) once();
  result.thread_share = (clock_s(CLOCK_THREAD_CPUTIME_ID) - thread) / duration_s;
  result.process_share = (clock_s(CLOCK_PROCESS_CPUTIME_ID) - process) / duration_s;
}

Result bare_loop(double duration_s) {
  Feeder feeder;
  const int fd = ::open(feeder.path().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (fd < 0) throw EnvironmentError("cannot open the terminal");
  Result result;
  ssize_t got = 0;  // of a frame
  run(duration_s, result, [&] {
    pollfd asked{fd, POLLIN, 0};
    char bytes[1024];
    if (::poll(&asked, 1, 100) <= 0) return;
    got += std::max<ssize_t>(0, ::read(fd, bytes, sizeof bytes));
    if (got < static_cast<ssize_t>(Feeder::frame_bytes)) return;
    got = 0;
    result.latency.add(now_ns() - feeder.sent_ns());
  });
  ::close(fd);
  return result;
}

/// As the container does: sleeps until a descriptor, an input or a deadline, then ticks.
void tick(Component& component) {
  Schedule& schedule = component.schedule();
  std::vector<pollfd> asked;
  for (const int fd : schedule.descriptors) asked.push_back({fd, POLLIN, 0});
  const auto left = std::max(schedule.due() - std::chrono::steady_clock::now(), Duration{0});
  const Duration limit = std::min<Duration>(left, std::chrono::milliseconds(100));
  const timespec wait{0, limit.count() % 1'000'000'000};
  ::ppoll(asked.data(), asked.size(), &wait, nullptr);
  const Time now = std::chrono::steady_clock::now();
  schedule.begin_tick(now);
  component.tick(now);
}

Result driver(double duration_s) {
  Feeder feeder;
  BusOptions options;
  options.name = "kobuki_bench";
  options.role = Role::uxv;
  options.qos_file = "config/qos.yaml";
  options.traffic_file = "config/traffic.yaml";
  options.host_domain = 187;
  const auto bus = make_fast_dds_bus(options);
  Result result;
  OdomWatch watch(*bus, [&] { result.latency.add(now_ns() - feeder.sent_ns()); });
  Context context{watch, "kobuki_driver", Role::uxv};
  YAML::Node parameters;
  parameters["device_port"] = feeder.path();
  const auto component =
      load_component("kobuki_driver").create(context, parameters, "kobuki_driver_cost");
  Result warm_up;
  run(1, warm_up, [&] { tick(*component); });
  run(duration_s, result, [&] { tick(*component); });
  return result;
}

void print(const char* name, const Result& result) {
  const auto us = [&](double share) { return 1e-3 * result.latency.percentile(share); };
  std::printf("%-22s %6zu  %8.1f %8.1f %8.1f   %6.2f %%   %6.2f %%\n", name, result.latency.size(),
              us(0.5), us(0.99), us(1), 100 * result.thread_share, 100 * result.process_share);
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  using namespace tocsin::bench;
  const double duration_s = argc > 1 ? std::atof(argv[1]) : 10;
  if (!(duration_s >= 1 && duration_s <= 600)) {
    std::fprintf(stderr, "kobuki_driver_cost: SECONDS must be 1 to 600\n");
    return 2;
  }
  try {
    std::printf(
        "50 frames a second for %.0f s; latency from the write of a frame's last bytes [us]\n",
        duration_s);
    std::printf("%-22s %6s  %8s %8s %8s   %8s   %8s\n", "", "frames", "median", "99 %", "worst",
                "thread", "process");
    print("bare poll and read", bare_loop(duration_s));
    print("driver to odom write", driver(duration_s));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kobuki_driver_cost: %s\n", error.what());
    return 1;
  }
}
