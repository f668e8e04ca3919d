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
    : logs_(std::make_unique<Shared<std::array<Log, 2>>>()) {
  const std::string qos_file = folder_.write(
      "qos.yaml", fmt::format("crossing: {{reliability: reliable, lifespan_s: {}}}\n", lifespan_s));
  const auto peer = [this, &qos_file](pid_t process, int host_domain, Way from, Way to) {
    peers_.push_back(std::make_unique<Peer>(process, on_host(host_domain, qos_file),
                                            [from](Bus& bus) { write_for_ever(bus, from); }));
    Log& log = (*logs_)->at(static_cast<std::size_t>(to));
    peers_.push_back(
        std::make_unique<Peer>(process, on_host(host_domain, qos_file), [to, &log](Bus& bus) {
          const auto reader = bus.subscribe(endpoint(to), log);
          for (;;) pause();
        }));
  };
  peer(vehicle, domain, Way::up, Way::down);
  peer(station, domain + 1, Way::down, Way::up);
}

Crossings::~Crossings() { peers_.clear(); }

const Crossings::Log& Crossings::log(Way way) const {
  return (*logs_)->at(static_cast<std::size_t>(way));
}

std::vector<Crossed> Crossings::all(Way way) const {
  const Log& from = log(way);
  const auto* const first = from.crossed.data();
  return {first, first + from.count.load(std::memory_order_acquire)};
}

std::optional<Crossed> Crossings::first_after(Way way, std::int64_t sent_ns) const {
  const Log& from = log(way);
  const auto* const first = from.crossed.data();
  const auto* const last = first + from.count.load(std::memory_order_acquire);
  const auto* const found =
      std::find_if(first, last, [sent_ns](const Crossed& one) { return one.sent_ns > sent_ns; });
  return found == last ? std::nullopt : std::optional(*found);
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
