// SPDX-License-Identifier: Apache-2.0
// Round trips between two processes: components against raw Fast DDS read by a wait-set, both on
// loopback UDP, and Cyclone's ddsperf when it is installed.
// The ways take turns, with new processes for each generation.
// usage: runtime_processes [--quick] [BYTES]
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bench_bus.hpp"
#include "raw_dds.hpp"
#include "runtime/middleware/runner.hpp"
#include "turns.hpp"

namespace tocsin::bench {
namespace {

constexpr std::array<std::size_t, 4> sizes{64, 1024, 65536, 1U << 20U};
constexpr int first_domain = 70;
struct Setting {
  const char* name;
  std::optional<RawType> raw;  // empty: components
  Timing timing;
  std::vector<std::size_t> rivals;
};
constexpr std::size_t way_count = 4;
const std::array<Setting, way_count> settings{
    {{"raw, octets, UDP", RawType::octets, Timing::raw, {}},
     {"raw, the same message, UDP", RawType::message, Timing::raw, {0}},
     {"components, UDP", {}, Timing::raw, {1, 0}},
     {"components, UDP, Tocsin's timing", {}, Timing::tocsin, {1, 0}}}};

std::unique_ptr<Bus> make_bus(const char* name, const Setting& setting, int domain) {
  return make_bench_bus(name, domain, setting.timing);
}

/// Until it is killed.
[[noreturn]] void echo(std::size_t index) {
  const Setting& setting = settings.at(index);
  const int domain = first_domain + static_cast<int>(index);
  if (setting.raw) {
    RawParticipant participant(domain, *setting.raw);
    const RawEcho echo(participant);
    for (;;) pause();
  }
  const auto bus = make_bus("echo", setting, domain);
  Context context{*bus, "echo", Role::uxv};
  Pong pong(context);
  TickAccount account;
  const Runner runner("echo", *bus, pong, account);
  for (;;) pause();
}

pid_t start_echo(std::size_t index) {
  const char* const self = "/proc/self/exe";
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    execl(self, self, "--echo", std::to_string(index).c_str(), nullptr);
    _exit(1);
  }
  return child;
}

/// Our end of one way, for one size.
class End : public Way {
 public:
  End(std::size_t index, std::size_t bytes) {
    const Setting& setting = settings.at(index);
    const int domain = first_domain + static_cast<int>(index);
    if (setting.raw) {
      participant_ = std::make_unique<RawParticipant>(domain, *setting.raw);
      raw_ = std::make_unique<RawPing>(*participant_, bytes);
      return;
    }
    bus_ = make_bus("ping", setting, domain);
    context_ = std::make_unique<Context>(Context{*bus_, "ping", Role::uxv});
    ping_ = std::make_unique<Ping>(*context_, bytes);
    runner_ = std::make_unique<Runner>("ping", *bus_, *ping_, account_);
  }
  ~End() override { runner_.reset(); }
  bool run(int trips, Series& series) override {
    return raw_ ? raw_->run(trips, series) : ping_->run(trips, series);
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

Generation set_up(std::size_t bytes) {
  Generation generation;
  generation.others = std::make_shared<Echoes>();
  std::vector<End*> ends;
  for (std::size_t i = 0; i < way_count; ++i) {
    auto end = std::make_unique<End>(i, bytes);
    ends.push_back(end.get());
    generation.ways.push_back(std::move(end));
  }
  // What is written to nobody is waited for in vain, two seconds each.
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  for (std::size_t i = 0; i < way_count; ++i) {
    if (!ends[i]->discover()) std::printf("%s: silent\n", settings.at(i).name);
  }
  return generation;
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

std::string load_text(std::size_t bytes) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%8zu B", bytes);
  return text.data();
}

/// `only`: one size in bytes; 0: all.
int measure(bool quick, std::size_t only) {
  std::printf(
      "round trip between processes [us], median / p99; raw Fast DDS is read by a wait-set\n");
  std::vector<Title> titles;
  for (const Setting& setting : settings) titles.push_back({setting.name, setting.rivals});
  for (const std::size_t bytes : sizes) {
    if (only != 0 && only != bytes) continue;
    const Plan plan{quick ? 4 : 32, 2, bytes > 65536 ? 30 : 150};
    compare(load_text(bytes), titles, plan, [bytes] { return set_up(bytes); });
  }
  if (!quick) cyclone(64);
  if (!quick) cyclone(65536);
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  using tocsin::bench::sizes;
  if (argc == 3 && std::strcmp(argv[1], "--echo") == 0)
    tocsin::bench::echo(std::strtoul(argv[2], nullptr, 10));
  bool quick = false;
  std::size_t only = 0;
  for (int i = 1; i < argc; ++i) {
    const auto size = std::find_if(sizes.begin(), sizes.end(), [&](std::size_t bytes) {
      return std::to_string(bytes) == argv[i];
    });
    if (size != sizes.end()) {
      only = *size;
    } else if (std::strcmp(argv[i], "--quick") == 0) {
      quick = true;
    } else {
      std::fprintf(stderr, "runtime_processes: '%s' is not --quick, 64, 1024, 65536 or 1048576\n",
                   argv[i]);
      return 2;
    }
  }
  return tocsin::bench::measure(quick, only);
}
