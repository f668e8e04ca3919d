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
#include "runner/runner.hpp"
#include "turns.hpp"

namespace tocsin::bench {
namespace {

struct Load {
  std::size_t bytes;
  int readers;
  int trips;  // in a turn
};

/// The answer is written in the listener, so the whole round trip is one call of write.
class RawListeners : public Way {
 public:
  explicit RawListeners(const Load& load)
      : participant_(61, RawParticipant::Transport::udp),
        message_(participant_.sample(load.bytes)),
        echo_(participant_,
              [this](void* sample) {
                (void)pong_->write(sample, eprosima::fastdds::dds::HANDLE_NIL);
              }),
        silent_(participant_, [](void*) {}),
        done_(participant_, [this](void*) { series_->add(now_ns() - sent_ns_); }) {
    pong_ = participant_.writer("pong");
    ping_ = participant_.writer("ping");
    participant_.reader("pong", &done_);
    for (int i = 1; i < load.readers; ++i) participant_.reader("ping", &silent_);
    participant_.reader("ping", &echo_);
  }
  bool run(int trips, Series& series) override {
    series_ = &series;
    for (int i = 0; i < trips; ++i) {
      sent_ns_ = now_ns();
      (void)ping_->write(message_.get(), eprosima::fastdds::dds::HANDLE_NIL);
    }
    return true;
  }

 private:
  RawParticipant participant_;
  std::shared_ptr<void> message_;
  RawListener echo_;
  RawListener silent_;
  RawListener done_;
  eprosima::fastdds::dds::DataWriter* pong_ = nullptr;
  eprosima::fastdds::dds::DataWriter* ping_ = nullptr;
  std::int64_t sent_ns_ = 0;
  Series* series_ = nullptr;
};

class RawWaitSets : public Way {
 public:
  explicit RawWaitSets(const Load& load)
      : participant_(62, RawParticipant::Transport::udp), ping_(participant_, load.bytes) {
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
  Components(const Load& load, bool one_thread)
      : one_thread_(one_thread),
        bus_(make_bench_bus("bench", one_thread ? 63 : 64, false)),
        context_{*bus_, "bench", Role::uxv},
        ping_(context_, load.bytes) {
    for (int i = load.readers - 1; i >= 0; --i) {
      pongs_.push_back(std::make_unique<Pong>(context_, i > 0));
    }
    add(ping_);
    for (const auto& pong : pongs_) add(*pong);
    for (Runner& runner : runners_) runner.start();
  }
  ~Components() override { runners_.clear(); }
  bool run(int trips, Series& series) override { return ping_.run(trips, series); }

 private:
  void add(Component& component) {
    if (runners_.empty() || !one_thread_) runners_.emplace_back("bench", *bus_);
    runners_.back().add(component, accounts_.emplace_back());
  }
  bool one_thread_;
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
  ways.push_back(std::make_unique<RawListeners>(load));
  ways.push_back(std::make_unique<Components>(load, true));
  ways.push_back(std::make_unique<RawWaitSets>(load));
  ways.push_back(std::make_unique<Components>(load, false));
  Series ignored;  // caches, discovery, memory
  for (const auto& way : ways) (void)way->run(20, ignored);
  return generation;
}

void measure(const Load& load, bool quick) {
  const std::vector<Title> titles{{"raw, octets, listeners", {}},
                                  {"components, one thread", {0}},
                                  {"raw, octets, wait-sets", {}},
                                  {"components, a thread each", {2}}};
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
