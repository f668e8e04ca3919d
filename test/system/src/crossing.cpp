// SPDX-License-Identifier: Apache-2.0
#include "crossing.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using Message = std_msgs::msg::String;
using std::chrono::milliseconds;

constexpr std::array<TopicInfo, 2> topics{
    {{"crossing/up", "crossing", Scope::host}, {"crossing/down", "crossing", Scope::host}}};
constexpr std::size_t most_crossed = 1U << 18U;  // 20 minutes

Endpoint endpoint(Crossings::Way way) {
  return {topics[static_cast<std::size_t>(way)], &type_info<Message>()};
}

BusOptions on_host(int domain, const std::string& qos_file) {
  BusOptions options;
  options.qos_file = qos_file;
  options.name = "crossing";
  options.host_domain = domain;
  return options;
}

void write_for_ever(Bus& bus, Crossings::Way way) {
  const auto writer = bus.advertise(endpoint(way));
  auto next = std::chrono::steady_clock::now();
  for (;;) {
    (void)writer->write(std::make_shared<const Message>());
    std::this_thread::sleep_until(next += milliseconds(5));
  }
}

}  // namespace

std::int64_t wall_now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string standing(const std::string& folder, const std::string& traffic,
                     const std::string& more) {
  std::ofstream(folder + "/standing_traffic.yaml") << traffic;
  std::string file = folder + "/standing.yaml";
  std::ofstream(file) << "extends: mission.yaml\n"
                         "traffic: standing_traffic.yaml\n"
                         "stop_when_exits: ~\n"
                         "hosts:\n"
                         "  gcs: {containers: [{mission: ~}, {view: ~}]}\n"
                      << more;
  return file;
}

std::string standing_mission(const std::string& folder, const std::string& more) {
  return standing(folder,
                  "extends: traffic.yaml\n"
                  "uxv:\n"
                  "  critical: {topics: [crossing/up]}\n"
                  "  high: {while_poor: latest, topics: [crossing/latest]}\n"
                  "  low: {topics: [crossing/image]}\n"
                  "gcs: {critical: {topics: [crossing/down, crossing/large]}}\n",
                  more);
}

bool routers_run(const Stack& stack) {
  return Stack::eventually(std::chrono::seconds(60), [&] {
    return stack.pid("uxv/link") != 0 && stack.pid("gcs/link") != 0;
  });
}

struct Crossings::Log : Receiver {
  void receive(const Sample& sample) override {
    const std::size_t at = count.load(std::memory_order_relaxed);
    if (at == most_crossed) return;
    crossed[at] = {sample.sent_wall_ns, sample.received_wall_ns};
    count.store(at + 1, std::memory_order_release);
  }
  std::atomic<std::size_t> count{0};
  std::array<Crossed, most_crossed> crossed{};
};

Crossings::Crossings(pid_t vehicle, pid_t station, int domain)
    : Crossings(vehicle, std::vector<pid_t>{station}, domain) {}

Crossings::Crossings(pid_t vehicle, const std::vector<pid_t>& stations, int domain)
    : qos_file_(folder_.write(
          "qos.yaml",
          fmt::format("crossing: {{reliability: reliable, lifespan_s: {}}}\n", lifespan_s))),
      logs_(std::make_unique<Shared<Logs>>()) {
  start(vehicle, domain, Way::up, (*logs_)->at(0));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    start(stations[i], domain + 1 + static_cast<int>(i), Way::down, (*logs_)->at(i + 1));
  }
}

Crossings::~Crossings() { peers_.clear(); }

/// Who writes that way, and who reads the other.
void Crossings::start(pid_t process, int host_domain, Way from, Log& log) {
  const Way to = from == Way::up ? Way::down : Way::up;
  peers_.push_back(std::make_unique<Peer>(process, on_host(host_domain, qos_file_),
                                          [from](Bus& bus) { write_for_ever(bus, from); }));
  peers_.push_back(
      std::make_unique<Peer>(process, on_host(host_domain, qos_file_), [to, &log](Bus& bus) {
        const auto reader = bus.subscribe(endpoint(to), log);
        for (;;) pause();
      }));
}

std::vector<Crossed> Crossings::all(Way way) const {
  std::vector<Crossed> all;
  for (std::size_t i = 0; i < (*logs_)->size(); ++i) {
    if ((i == 0) != (way == Way::down)) continue;
    const Log& from = (*logs_)->at(i);
    const auto* const first = from.crossed.data();
    all.insert(all.end(), first, first + from.count.load(std::memory_order_acquire));
  }
  std::stable_sort(all.begin(), all.end(), [](const Crossed& one, const Crossed& other) {
    return one.received_ns < other.received_ns;
  });
  return all;
}

std::optional<Crossed> Crossings::first_after(Way way, std::int64_t sent_ns) const {
  const auto crossed = all(way);
  const auto found = std::find_if(crossed.begin(), crossed.end(),
                                  [sent_ns](const Crossed& one) { return one.sent_ns > sent_ns; });
  return found == crossed.end() ? std::nullopt : std::optional(*found);
}

bool Crossings::has_come(std::size_t station, std::int64_t sent_ns) const {
  const Log& from = (*logs_)->at(station + 1);
  const std::size_t count = from.count.load(std::memory_order_acquire);
  return count > 0 && from.crossed[count - 1].sent_ns > sent_ns;
}

double Crossings::longest_gap_s(Way way, std::int64_t from_ns) const {
  std::int64_t longest_ns = 0;
  std::int64_t last_ns = from_ns;
  for (const Crossed& one : all(way)) {
    if (one.received_ns < from_ns) continue;
    longest_ns = std::max(longest_ns, one.received_ns - last_ns);
    last_ns = one.received_ns;
  }
  longest_ns = std::max(longest_ns, wall_now_ns() - last_ns);
  return 1e-9 * static_cast<double>(longest_ns);
}

std::optional<Recovery> kill_and_time(const Stack& stack, const std::string& process,
                                      const Crossings& crossings) {
  const pid_t before = stack.pid(process);
  const std::int64_t killed = wall_now_ns();
  if (before == 0 || kill(before, SIGKILL) != 0) return std::nullopt;
  const auto up = [&] { return crossings.first_after(Crossings::Way::up, killed); };
  const auto down = [&] { return crossings.first_after(Crossings::Way::down, killed); };
  if (!Stack::eventually(std::chrono::seconds(20), [&] { return up() && down(); }))
    return std::nullopt;
  const auto after = [killed](const Crossed& one) {
    return 1e-9 * static_cast<double>(one.received_ns - killed);
  };
  return Recovery{killed, after(*up()), after(*down())};
}

}  // namespace tocsin
