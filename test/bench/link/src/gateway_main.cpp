// SPDX-License-Identifier: Apache-2.0
// A robot that knows nothing of this stack, over the emulated radio: by bringup/gateway.yaml, and
// in the same run straight from Fast DDS to Fast DDS. Per stream what arrives and when, and the CPU
// time of both routers. usage: link_gateway [SECONDS [CHANNEL [X Y]]]    CHANNEL: a file of
// config/radio without its end
#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "crossing.hpp"
#include "foreign_robot.hpp"
#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "foundation/whole_number.hpp"
#include "measure.hpp"

namespace {

using namespace tocsin;
using bench::Place;
using bench::RobotLog;
using bench::StreamLog;
using std::chrono::seconds;

constexpr const char* vehicle = "10.77.0.1";
constexpr const char* station = "10.77.0.2";
constexpr int direct_domain = 70;
constexpr std::int64_t late_ns = 250'000'000;  // as the link router counts

/// What is measured, and where the vehicle stands.
struct Trial {
  int seconds = 30;
  std::string channel = "classroom";
  std::string position = "pos 1 1";
};

/// A log in memory that children share.
class SharedLog {
 public:
  SharedLog() {
    void* const memory =
        mmap(nullptr, sizeof(RobotLog), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no shared memory");
    log_ = new (memory) RobotLog;
  }
  ~SharedLog() { munmap(log_, sizeof(RobotLog)); }
  SharedLog(const SharedLog&) = delete;
  SharedLog& operator=(const SharedLog&) = delete;
  RobotLog& operator*() { return *log_; }
  RobotLog* operator->() { return log_; }

 private:
  RobotLog* log_;
};

/// [s] within the window, its ends included.
double longest_gap_s(const StreamLog& own, const RobotLog& log) {
  std::int64_t last_ns = log.from_ns;
  std::int64_t longest_ns = 0;
  for (std::uint32_t k = 0; k < own.arrived; ++k) {
    longest_ns = std::max(longest_ns, own.arrived_ns[k] - last_ns);
    last_ns = own.arrived_ns[k];
  }
  return 1e-9 * static_cast<double>(std::max(longest_ns, log.until_ns - last_ns));
}

void print(const char* way, const RobotLog& log, int run_s) {
  for (std::size_t i = 0; i < bench::streams.size(); ++i) {
    const StreamLog& own = log.of[i];
    bench::Series latency;
    for (std::uint32_t k = 0; k < own.arrived; ++k) latency.add(own.latency_ns[k]);
    const double written = std::max(1U, own.written.load());
    fmt::print("{:<7} {:<33} {:<9} {:6.1f} {:6.1f} {:6.1f} {:6.1f} {:7.0f} {:7.0f} {:6.2f}\n", way,
               bench::streams[i].topic, bench::streams[i].traffic_class, written / run_s,
               static_cast<double>(own.arrived) / run_s, 100 * own.arrived / written,
               100.0 * latency.above(late_ns) / std::max(1U, own.arrived.load()),
               1e-6 * latency.percentile(0.5), 1e-6 * latency.percentile(0.95),
               longest_gap_s(own, log));
  }
}

/// Opens the window once each stream was heard and the vehicle stands where it should, and waits
/// for what is late.
void observe(const Stack& stack, RobotLog& log, const Trial& trial) {
  const bool all = Stack::eventually(seconds(30), [&] {
    for (const StreamLog& own : log.of) {
      if (own.heard == 0) return false;
    }
    return true;
  });
  if (!all) fmt::print("not every stream was heard within 30 s\n");
  stack.control("radio.sock", trial.position);
  const std::int64_t now = wall_now_ns();
  log.until_ns = now + trial.seconds * std::int64_t{1'000'000'000};
  log.from_ns = now;
  std::this_thread::sleep_for(seconds(trial.seconds + 3));
}

double megabytes(const RobotLog& log) {
  double bytes = 0;
  for (const StreamLog& own : log.of) bytes += static_cast<double>(own.bytes.load());
  return 1e-6 * bytes;
}

/// Rate of what came [MB/s], and what both routers computed meanwhile [cores].
struct Cost {
  double rate;
  double cores;
};

Cost measure_one(const Stack& stack, const Trial& trial, const char* way, Place robot,
                 Place tools) {
  const pid_t at_robot = stack.pid("uxv/link");
  const pid_t at_station = stack.pid("gcs/link");
  stack.control("radio.sock", "pos 1 1");  // where all find each other
  SharedLog log;
  const Peer first(at_robot, [&] { bench::be_foreign(robot, true, *log); });
  const Peer second(at_station, [&] { bench::be_foreign(tools, false, *log); });
  const double before = bench::cpu_s(at_robot) + bench::cpu_s(at_station);
  const std::int64_t began = wall_now_ns();
  observe(stack, *log, trial);
  const double cores = (bench::cpu_s(at_robot) + bench::cpu_s(at_station) - before) /
                       (1e-9 * static_cast<double>(wall_now_ns() - began));
  print(way, *log, trial.seconds);
  return {megabytes(*log) / trial.seconds, cores};
}

void measure(const Trial& trial) {
  const TemporaryFolder folder;
  const Stack stack(
      {folder.write("gateway_on_one_computer.yaml",
                    fmt::format("extends: gateway.yaml\n"
                                "radio:\n"
                                "  channel: ${{share}}/config/radio/{}.yaml\n"
                                "  walls: ${{share}}/config/maps/classroom.walls.yaml\n",
                                trial.channel)),
       "--seed", "1"});
  const auto meet = [&] {
    return stack.logged("gcs is on the link") && stack.logged("uxv is on the link");
  };
  if (!Stack::eventually(seconds(60), meet)) throw std::runtime_error(stack.output());
  fmt::print("{}, {}, {} s each\n{:<7} {:<33} {:<9} {:>6} {:>6} {:>6} {:>6} {:>7} {:>7} {:>6}\n",
             trial.channel, trial.position, trial.seconds, "way", "topic", "class", "Hz", "come Hz",
             "come %", "late %", "p50 ms", "p95 ms", "gap s");
  const Cost routed = measure_one(stack, trial, "router", {0}, {1});
  const Cost direct =
      measure_one(stack, trial, "direct", {direct_domain, station}, {direct_domain, vehicle});
  fmt::print(
      "router {:.3f} MB/s, direct {:.3f} MB/s; both routers {:.3f} cores, idle {:.3f}: "
      "{:.2f} cores per MB/s\n",
      routed.rate, direct.rate, routed.cores, direct.cores,
      (routed.cores - direct.cores) / routed.rate);
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("link_gateway", [&] {
    Trial trial;
    if (argc > 1) trial.seconds = static_cast<int>(whole_number(argv[1], "SECONDS", 1, 86400));
    if (argc > 2) trial.channel = argv[2];
    if (argc > 4) trial.position = fmt::format("pos {} {}", argv[3], argv[4]);
    measure(trial);
    return 0;
  });
}
