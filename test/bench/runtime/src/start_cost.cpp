// SPDX-License-Identifier: Apache-2.0
#include "start_cost.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <list>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench_bus.hpp"
#include "runtime/middleware/runner.hpp"

namespace tocsin::bench {
namespace {

constexpr int start_domain = 80;

/// Names that live as long as the program: a topic keeps pointers.
const char* numbered(const char* word, int number) {
  static std::list<std::string> all;
  return all.emplace_back(word + std::to_string(number)).c_str();
}

Endpoint topic(const char* word, int number) {
  return {{numbered(word, number), "bench", Scope::host}, &type_info<Blob>()};
}

/// Reads one topic and writes another, both of which nobody else has in this process.
class Station : public Component {
 public:
  Station(Context& context, const Endpoint& in, const Endpoint& out)
      : Component(context), in_(*this, in), out_(context.bus.advertise(out)) {
    wake_every(std::chrono::milliseconds(20));
  }
  void tick(Time) override {
    while (in_.take_sample()) heard_ = true;
    (void)out_->write(message_);
  }
  [[nodiscard]] bool heard() const { return heard_; }

 private:
  InputPort in_;
  std::unique_ptr<Publication> out_;
  std::shared_ptr<const Blob> message_ = blob(64);
  std::atomic<bool> heard_{false};
};

/// A process with `count` components, each of which talks to its fellow in the other process.
class Crowd {
 public:
  Crowd(const char* mine, const char* theirs, int count)
      : bus_(make_bench_bus(mine, start_domain)), context_{*bus_, mine, Role::uxv} {
    for (int i = 0; i < count; ++i) {
      stations_.emplace_back(context_, topic(theirs, i), topic(mine, i));
    }
    for (Station& station : stations_) {
      runners_.emplace_back("station", *bus_, station, accounts_.emplace_back());
    }
  }
  ~Crowd() { runners_.clear(); }
  [[nodiscard]] bool wait_until_heard(int patience_ms) const {
    for (int ms = 0; ms < patience_ms; ++ms) {
      bool all = true;
      for (const Station& station : stations_) all = all && station.heard();
      if (all) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

 private:
  std::unique_ptr<Bus> bus_;
  Context context_;
  std::list<Station> stations_;
  std::list<TickAccount> accounts_;
  std::list<Runner> runners_;
};

/// `exec_ns`: when it was started, before fork and exec.
int crowd_child(const char* mine, const char* theirs, int count, std::int64_t exec_ns) {
  const long before = proc_number("/proc/self/smaps_rollup", "Pss");
  const double main_ms = static_cast<double>(now_ns() - exec_ns) / 1e6;
  const Crowd crowd(mine, theirs, count);
  const double made_ms = static_cast<double>(now_ns() - exec_ns) / 1e6;
  const bool heard = crowd.wait_until_heard(20000);
  const double heard_ms = static_cast<double>(now_ns() - exec_ns) / 1e6;
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  std::printf(
      "%3d components, %3d endpoints, since exec: in main after %5.1f ms, made after %6.1f ms, "
      "%s %7.1f ms; PSS %5.1f MB (%4.1f before), %ld threads\n",
      count, 2 * count, main_ms, made_ms,
      heard ? "all heard the other process after" : "NOT ALL HEARD in", heard_ms,
      static_cast<double>(proc_number("/proc/self/smaps_rollup", "Pss")) / 1024,
      static_cast<double>(before) / 1024, proc_number("/proc/self/status", "Threads"));
  std::fflush(stdout);
  return 0;
}

pid_t start(std::vector<const char*> arguments) {
  const pid_t child = fork();
  if (child != 0) return child;
  arguments.insert(arguments.begin(), {"runtime_cost", "--child"});
  arguments.push_back(nullptr);
  execv("/proc/self/exe", const_cast<char**>(arguments.data()));
  _exit(1);
}

void end(pid_t child, int signal) {
  kill(child, signal);
  waitpid(child, nullptr, 0);
}

}  // namespace

void print_start_costs() {
  for (const char* count : {"10", "15", "15", "15", "50", "50", "50", "100"}) {
    const pid_t other = start({"left", "right", count});
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    const std::string exec_ns = std::to_string(now_ns());
    waitpid(start({"right", "left", count, exec_ns.c_str()}), nullptr, 0);
    end(other, SIGKILL);
  }
}

int run_child(int argc, char** argv) {
  if (argc < 3) return 2;
  if (argc > 3) {
    return crowd_child(argv[0], argv[1], std::atoi(argv[2]), std::strtoll(argv[3], nullptr, 10));
  }
  const Crowd crowd(argv[0], argv[1], std::atoi(argv[2]));  // the other side, silent about itself
  for (;;) pause();
}

}  // namespace tocsin::bench
