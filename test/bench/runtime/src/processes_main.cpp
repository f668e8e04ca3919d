// SPDX-License-Identifier: Apache-2.0
// Round trips between two processes: components against raw Fast DDS read by a wait-set, both on
// loopback UDP and on shared memory, and Cyclone's ddsperf when it is installed.
// usage: runtime_processes [--quick [BYTES]]
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench_bus.hpp"
#include "raw_dds.hpp"
#include "runner.hpp"

namespace tocsin::bench {
namespace {

constexpr int first_domain = 70;
struct Way {
  const char* name;
  bool raw;
  bool shared_memory;
};
constexpr Way ways[] = {{"raw Fast DDS, wait-set, UDP", true, false},
                        {"components, UDP", false, false},
                        {"raw Fast DDS, wait-set, SHM", true, true},
                        {"components, SHM", false, true}};

RawParticipant::Transport transport_of(const Way& way) {
  return way.shared_memory ? RawParticipant::Transport::shared_memory
                           : RawParticipant::Transport::udp;
}

/// Until it is killed.
[[noreturn]] void echo(int index) {
  const Way& way = ways[index];
  if (way.raw) {
    RawParticipant participant(first_domain + index, transport_of(way));
    const RawEcho echo(participant);
    for (;;) pause();
  }
  const auto bus = make_bench_bus("echo", first_domain + index, way.shared_memory);
  Context context{*bus, "echo", "uxv", ""};
  Pong pong(context);
  TickAccount account;
  Runner runner("echo", *bus);
  runner.add(pong, account);
  runner.start();
  for (;;) pause();
}

pid_t start_echo(const char* self, int index) {
  const pid_t child = fork();
  if (child == 0) {
    execl(self, self, "--echo", std::to_string(index).c_str(), nullptr);
    _exit(1);
  }
  return child;
}

/// Our end of one way, for one size.
class End {
 public:
  End(int index, std::size_t bytes) {
    const Way& way = ways[index];
    if (way.raw) {
      participant_ = std::make_unique<RawParticipant>(first_domain + index, transport_of(way));
      raw_ = std::make_unique<RawPing>(*participant_, bytes);
      return;
    }
    bus_ = make_bench_bus("ping", first_domain + index, way.shared_memory);
    context_ = std::make_unique<Context>(Context{*bus_, "ping", "uxv", ""});
    ping_ = std::make_unique<Ping>(*context_, bytes);
    runner_ = std::make_unique<Runner>("ping", *bus_);
    runner_->add(*ping_, account_);
    runner_->start();
  }
  ~End() { runner_.reset(); }
  bool run(int count) { return raw_ ? raw_->run(count, series) : ping_->run(count, series); }
  bool discover() {
    for (int i = 0; i < 5; ++i) {
      if (run(20)) {
        series = {};
        return true;
      }
    }
    return false;
  }
  Series series;

 private:
  std::unique_ptr<RawParticipant> participant_;
  std::unique_ptr<RawPing> raw_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Ping> ping_;
  TickAccount account_;
  std::unique_ptr<Runner> runner_;
};

void compare(std::size_t bytes, int count, int rounds) {
  std::vector<std::unique_ptr<End>> ends;
  for (int i = 0; i < 4; ++i) ends.push_back(std::make_unique<End>(i, bytes));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // discovery
  for (int i = 0; i < 4; ++i) {
    if (!ends[static_cast<std::size_t>(i)]->discover()) std::printf("%s: silent\n", ways[i].name);
  }
  for (int round = 0; round < rounds; ++round) {
    for (const auto& end : ends) (void)end->run(count / rounds);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Series& rival = ends[i < 2 ? 0 : 2]->series;
    const Series& own = ends[i]->series;
    std::printf("%8zu B  %-28s %s   %6.3f / %6.3f\n", bytes, ways[i].name, own.text().c_str(),
                own.percentile(0.5) / rival.percentile(0.5),
                own.percentile(0.99) / rival.percentile(0.99));
  }
}

void cyclone(std::size_t bytes) {
  const std::string config =
      "CYCLONEDDS_URI='<General><Interfaces><NetworkInterface name=\"lo\"/></Interfaces>"
      "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</"
      "ParticipantIndex><Peers>"
      "<Peer address=\"127.0.0.1\"/></Peers></Discovery>' ";
  const std::string text =
      output_of("(" + config + "timeout 5 ddsperf -i 90 -D4 pong >/dev/null 2>&1 &) ; sleep 0.3; " +
                config + "timeout 5 ddsperf -i 90 -D3 ping size " + std::to_string(bytes) +
                " 2>/dev/null | grep mean");
  const std::size_t last = text.rfind("mean", text.size() - 1);
  std::printf("%8zu B  ddsperf (half a round trip): %s", bytes,
              last == std::string::npos ? "not installed\n" : text.substr(last).c_str());
}

/// `only`: one size in bytes; 0: all.
int measure(const char* self, bool quick, std::size_t only) {
  std::vector<pid_t> echoes;
  for (int i = 0; i < 4; ++i) echoes.push_back(start_echo(self, i));
  const int n = quick ? 10 : 1;
  std::printf("round trip between processes [us], median / p99, share of the rival above it\n");
  for (const std::size_t bytes : {64U, 1024U, 65536U, 1U << 20U}) {
    const int count = bytes > 65536 ? 800 : 8000;
    if (only == 0 || only == bytes) compare(bytes, count / n, quick ? 2 : 8);
  }
  for (const pid_t child : echoes) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  if (!quick) cyclone(64);
  if (!quick) cyclone(65536);
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--echo") == 0) tocsin::bench::echo(std::atoi(argv[2]));
  const std::size_t only = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  return tocsin::bench::measure("/proc/self/exe", quick, only);
}
