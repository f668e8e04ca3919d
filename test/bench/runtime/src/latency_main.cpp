// SPDX-License-Identifier: Apache-2.0
// Round trips inside one process: components of one container against raw Fast DDS intra-process.
// The ways take turns in this process, and are set up anew for each generation.
// usage: runtime_latency [--quick]
#include <array>
#include <cstdio>
#include <cstring>
#include <list>
#include <memory>
#include <vector>

#include "bench_bus.hpp"
#include "raw_dds.hpp"
#include "runtime/middleware/runner.hpp"
#include "turns.hpp"

namespace tocsin::bench {
namespace {

struct Load {
  std::size_t bytes;
  int readers;
  int trips;  // in a turn
};

class RawWaitSets : public Way {
 public:
  explicit RawWaitSets(const Load& load) : participant_(62), ping_(participant_, load.bytes) {
    for (int i = 0; i < load.readers; ++i) {
      echoes_.push_back(std::make_unique<RawEcho>(participant_, i > 0));
    }
  }
  bool run(int trips, Series& series) override { return ping_.run(trips, series); }

 private:
  RawParticipant participant_;
  RawPing ping_;
  std::vector<std::unique_ptr<RawEcho>> echoes_;
};

class Components : public Way {
 public:
  explicit Components(const Load& load)
      : bus_(make_bench_bus("bench", 64)),
        context_{*bus_, "bench", Role::uxv},
        ping_(context_, load.bytes) {
    for (int i = load.readers - 1; i >= 0; --i) {
      pongs_.push_back(std::make_unique<Pong>(context_, i > 0));
    }
    add(ping_);
    for (const auto& pong : pongs_) add(*pong);
  }
  ~Components() override { runners_.clear(); }
  bool run(int trips, Series& series) override { return ping_.run(trips, series); }

 private:
  void add(Component& component) {
    runners_.emplace_back("bench", *bus_, component, accounts_.emplace_back());
  }
  std::unique_ptr<Bus> bus_;
  Context context_;
  Ping ping_;
  std::vector<std::unique_ptr<Pong>> pongs_;
  std::list<TickAccount> accounts_;
  std::list<Runner> runners_;
};

Generation set_up(const Load& load) {
  Generation generation;
  auto& ways = generation.ways;
  ways.push_back(std::make_unique<RawWaitSets>(load));
  ways.push_back(std::make_unique<Components>(load));
  Series ignored;  // caches, discovery, memory
  for (const auto& way : ways) (void)way->run(20, ignored);
  return generation;
}

void measure(const Load& load, bool quick) {
  const std::vector<Title> titles{{"raw, octets, wait-sets", {}},
                                  {"components, a thread each", {0}}};
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%8zu B 1:%-2d", load.bytes, load.readers);
  compare(text.data(), titles, {quick ? 4 : 16, 2, load.trips}, [&] { return set_up(load); });
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf("round trip in one process [us], median / p99; raw: Fast DDS\n");
  for (const int readers : {1, 10}) {
    for (const std::size_t bytes : {64U, 1024U, 65536U, 1U << 20U}) {
      tocsin::bench::measure({bytes, readers, bytes > 65536 ? 40 : 400}, quick);
    }
  }
  return 0;
}
