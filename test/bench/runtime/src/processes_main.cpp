// SPDX-License-Identifier: Apache-2.0
// Round trips between two processes: components against raw Fast DDS read by a wait-set, both on
// loopback UDP and on shared memory, and Cyclone's ddsperf when it is installed.
// The ways take turns, a few round trips each, forwards and backwards, with new processes every few
// blocks of turns; a share is the median over the blocks, with its 95 % confidence interval.
// usage: runtime_processes [--quick [BYTES]]
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
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
  Timing timing;
  std::size_t rival;
};
constexpr std::size_t way_count = 5;
constexpr std::array<Way, way_count> ways{
    {{"raw Fast DDS, wait-set, UDP", true, false, Timing::raw, 0},
     {"components, UDP", false, false, Timing::raw, 0},
     {"components, UDP, Tocsin's timing", false, false, Timing::tocsin, 0},
     {"raw Fast DDS, wait-set, SHM", true, true, Timing::raw, 3},
     {"components, SHM", false, true, Timing::raw, 3}}};

RawParticipant::Transport transport_of(const Way& way) {
  return way.shared_memory ? RawParticipant::Transport::shared_memory
                           : RawParticipant::Transport::udp;
}

/// Until it is killed.
[[noreturn]] void echo(std::size_t index) {
  const Way& way = ways.at(index);
  const int domain = first_domain + static_cast<int>(index);
  if (way.raw) {
    RawParticipant participant(domain, transport_of(way));
    const RawEcho echo(participant);
    for (;;) pause();
  }
  const auto bus = make_bench_bus("echo", domain, way.shared_memory, way.timing);
  Context context{*bus, "echo", "uxv", ""};
  Pong pong(context);
  TickAccount account;
  Runner runner("echo", *bus);
  runner.add(pong, account);
  runner.start();
  for (;;) pause();
}

pid_t start_echo(std::size_t index) {
  const char* const self = "/proc/self/exe";
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
  End(std::size_t index, std::size_t bytes) {
    const Way& way = ways.at(index);
    const int domain = first_domain + static_cast<int>(index);
    if (way.raw) {
      participant_ = std::make_unique<RawParticipant>(domain, transport_of(way));
      raw_ = std::make_unique<RawPing>(*participant_, bytes);
      return;
    }
    bus_ = make_bench_bus("ping", domain, way.shared_memory, way.timing);
    context_ = std::make_unique<Context>(Context{*bus_, "ping", "uxv", ""});
    ping_ = std::make_unique<Ping>(*context_, bytes);
    runner_ = std::make_unique<Runner>("ping", *bus_);
    runner_->add(*ping_, account_);
    runner_->start();
  }
  ~End() { runner_.reset(); }
  bool run(int count, Series& series) {
    return raw_ ? raw_->run(count, series) : ping_->run(count, series);
  }
  bool discover() {
    Series ignored;
    for (int i = 0; i < 5; ++i) {
      if (run(20, ignored)) return true;
    }
    return false;
  }

 private:
  std::unique_ptr<RawParticipant> participant_;
  std::unique_ptr<RawPing> raw_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Ping> ping_;
  TickAccount account_;
  std::unique_ptr<Runner> runner_;
};

struct Plan {
  int generations;  // of processes: where the scheduler puts two of them stays for their life
  int blocks;       // of a generation
  int turns;        // of each way in a block
  int trips;        // in a turn
};

/// Round trips of one block, by way.
using Block = std::array<Series, way_count>;

Block take_turns(const std::vector<std::unique_ptr<End>>& ends, const Plan& plan) {
  Block block;
  for (int turn = 0; turn < plan.turns; ++turn) {
    for (std::size_t i = 0; i < way_count; ++i) {
      const std::size_t way = turn % 2 == 0 ? i : way_count - 1 - i;
      (void)ends[way]->run(plan.trips, block.at(way));
    }
  }
  return block;
}

void print(std::size_t bytes, const std::vector<Block>& blocks) {
  for (std::size_t way = 0; way < way_count; ++way) {
    Series all;
    std::vector<double> medians;
    std::vector<double> tails;
    for (const Block& block : blocks) {
      const Series& rival = block.at(ways.at(way).rival);
      all.add(block.at(way));
      medians.push_back(block.at(way).percentile(0.5) / rival.percentile(0.5));
      tails.push_back(block.at(way).percentile(0.99) / rival.percentile(0.99));
    }
    std::printf("%8zu B  %-32s %s   median %s   p99 %s\n", bytes, ways.at(way).name,
                all.text().c_str(), share_text(medians).c_str(), share_text(tails).c_str());
  }
}

/// The other ends, until it is destroyed.
class Echoes {
 public:
  Echoes() {
    for (std::size_t i = 0; i < way_count; ++i) children_.push_back(start_echo(i));
  }
  ~Echoes() {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }
  Echoes(const Echoes&) = delete;
  Echoes& operator=(const Echoes&) = delete;

 private:
  std::vector<pid_t> children_;
};

void run_generation(std::size_t bytes, const Plan& plan, std::vector<Block>& blocks) {
  const Echoes echoes;
  std::vector<std::unique_ptr<End>> ends;
  for (std::size_t i = 0; i < way_count; ++i) ends.push_back(std::make_unique<End>(i, bytes));
  for (std::size_t i = 0; i < way_count; ++i) {
    if (!ends[i]->discover()) std::printf("%s: silent\n", ways.at(i).name);
  }
  for (int i = 0; i < plan.blocks; ++i) blocks.push_back(take_turns(ends, plan));
}

void compare(std::size_t bytes, const Plan& plan) {
  std::vector<Block> blocks;
  for (int i = 0; i < plan.generations; ++i) run_generation(bytes, plan, blocks);
  print(bytes, blocks);
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
int measure(bool quick, std::size_t only) {
  std::printf("round trip between processes [us], median / p99; share of the raw one above it\n");
  for (const std::size_t bytes : {64U, 1024U, 65536U, 1U << 20U}) {
    const Plan plan{quick ? 2 : 8, 3, 6, bytes > 65536 ? 10 : 50};
    if (only == 0 || only == bytes) compare(bytes, plan);
  }
  if (!quick) cyclone(64);
  if (!quick) cyclone(65536);
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--echo") == 0)
    tocsin::bench::echo(std::strtoul(argv[2], nullptr, 10));
  const std::size_t only = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  return tocsin::bench::measure(quick, only);
}
