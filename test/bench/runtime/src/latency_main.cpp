// SPDX-License-Identifier: Apache-2.0
// Round trips inside one process: components of one container against raw Fast DDS intra-process.
// usage: runtime_latency [--quick]
#include <cstdio>
#include <cstring>
#include <list>
#include <memory>
#include <vector>

#include "bench_bus.hpp"
#include "raw_dds.hpp"
#include "runner.hpp"

namespace tocsin::bench {
namespace {

struct Load {
  std::size_t bytes;
  int readers;
  int count;
};

/// Something that does round trips.
class Contender {
 public:
  virtual ~Contender() = default;
  virtual bool run(int count) = 0;
  [[nodiscard]] virtual const char* name() const = 0;
  Series series;
};

/// The answer is written in the listener, so the whole round trip is one call of write.
class RawListeners : public Contender {
 public:
  explicit RawListeners(const Load& load)
      : bytes_(load.bytes),
        participant_(61, RawParticipant::Transport::udp),
        echo_([this](const Bytes& bytes) {
          (void)pong_->write(const_cast<Bytes*>(&bytes), eprosima::fastdds::dds::HANDLE_NIL);
        }),
        silent_([](const Bytes&) {}),
        done_([this](const Bytes&) { series.add(now_ns() - sent_ns_); }) {
    pong_ = participant_.writer("pong");
    ping_ = participant_.writer("ping");
    participant_.reader("pong", &done_);
    for (int i = 1; i < load.readers; ++i) participant_.reader("ping", &silent_);
    participant_.reader("ping", &echo_);
  }
  bool run(int count) override {
    for (int i = 0; i < count; ++i) {
      sent_ns_ = now_ns();
      (void)ping_->write(&bytes_, eprosima::fastdds::dds::HANDLE_NIL);
    }
    return true;
  }
  [[nodiscard]] const char* name() const override { return "raw Fast DDS, listeners"; }

 private:
  Bytes bytes_;
  RawParticipant participant_;
  RawListener echo_;
  RawListener silent_;
  RawListener done_;
  eprosima::fastdds::dds::DataWriter* pong_ = nullptr;
  eprosima::fastdds::dds::DataWriter* ping_ = nullptr;
  std::int64_t sent_ns_ = 0;
};

class RawWaitSets : public Contender {
 public:
  explicit RawWaitSets(const Load& load)
      : participant_(62, RawParticipant::Transport::udp), ping_(participant_, load.bytes) {
    for (int i = 0; i < load.readers; ++i) {
      echoes_.push_back(std::make_unique<RawEcho>(participant_, i > 0));
    }
  }
  bool run(int count) override { return ping_.run(count, series); }
  [[nodiscard]] const char* name() const override { return "raw Fast DDS, wait-sets"; }

 private:
  RawParticipant participant_;
  RawPing ping_;
  std::vector<std::unique_ptr<RawEcho>> echoes_;
};

class Components : public Contender {
 public:
  Components(const Load& load, bool one_thread)
      : one_thread_(one_thread),
        bus_(make_bench_bus("bench", one_thread ? 63 : 64, false)),
        context_{*bus_, "bench", "uxv", ""},
        ping_(context_, load.bytes) {
    for (int i = load.readers - 1; i >= 0; --i) {
      pongs_.push_back(std::make_unique<Pong>(context_, i > 0));
    }
    add(ping_);
    for (const auto& pong : pongs_) add(*pong);
    for (Runner& runner : runners_) runner.start();
  }
  ~Components() override { runners_.clear(); }
  bool run(int count) override { return ping_.run(count, series); }
  [[nodiscard]] const char* name() const override {
    return one_thread_ ? "components, one thread" : "components, a thread each";
  }

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

void compare(const Load& load, bool quick) {
  std::vector<std::unique_ptr<Contender>> all;
  all.push_back(std::make_unique<RawListeners>(load));
  all.push_back(std::make_unique<Components>(load, true));
  all.push_back(std::make_unique<RawWaitSets>(load));
  all.push_back(std::make_unique<Components>(load, false));
  for (const auto& one : all) {  // caches, discovery, memory
    (void)one->run(100);
    one->series = {};
  }
  const int rounds = quick ? 2 : 8;
  for (int round = 0; round < rounds; ++round) {
    for (const auto& one : all) {
      if (!one->run(load.count / rounds)) std::printf("%s: no answer\n", one->name());
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double rival = all[i < 2 ? 0 : 2]->series.percentile(0.5);
    std::printf("%8zu B 1:%-2d  %-26s %s   %7.4f\n", load.bytes, load.readers, all[i]->name(),
                all[i]->series.text().c_str(), all[i]->series.percentile(0.5) / rival);
  }
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int n = quick ? 10 : 1;
  std::printf("round trip in one process [us], median / p99, share of the rival above it\n");
  for (const int readers : {1, 10}) {
    tocsin::bench::compare({64, readers, 20000 / n}, quick);
    tocsin::bench::compare({1024, readers, 20000 / n}, quick);
    tocsin::bench::compare({65536, readers, 4000 / n}, quick);
    tocsin::bench::compare({1U << 20U, readers, 800 / n}, quick);
  }
  return 0;
}
