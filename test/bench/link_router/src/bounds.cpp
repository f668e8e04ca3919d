// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <unordered_map>

#include "link_run.hpp"

namespace tocsin::bench {
namespace {

constexpr Duration period = std::chrono::milliseconds(5);
constexpr int packet_bytes = 100;

/// When the packets were sent that arrived, and when they did.
struct Arrival {
  Time sent;
  Time at;
};

std::vector<Arrival> arrivals(const MissionTraffic& traffic, const Steps& steps,
                              std::uint64_t seed) {
  radio::ChannelParams params = traffic.channel;
  params.access_categories = steps.categories;
  radio::RadioChannel channel(params, traffic.walls, seed, traffic.begin);
  std::unordered_map<radio::FrameId, Time> sent;
  std::vector<Arrival> arrived;
  std::size_t place = 0;
  for (Time now = traffic.begin; now < traffic.end; now += period) {
    for (; place < traffic.places.size() && traffic.places[place].time <= now; ++place) {
      channel.set_position(traffic.places[place].x_m, traffic.places[place].y_m);
    }
    const radio::Packet packet{packet_bytes, false, radio::AccessCategory::voice};
    sent[channel.push(radio::Direction::uplink, packet, now)] = now;
    channel.advance(now + period);
    while (const auto outcome = channel.take()) {
      const Time written = sent.at(outcome->id);
      sent.erase(outcome->id);
      if (outcome->fate == radio::Fate::delivered) arrived.push_back({written, outcome->at});
    }
  }
  std::sort(arrived.begin(), arrived.end(),
            [](const Arrival& one, const Arrival& other) { return one.sent < other.sent; });
  return arrived;
}

}  // namespace

void add_bounds(const MissionTraffic& traffic, const Steps& steps, std::uint64_t seed,
                Figures& figures) {
  const auto arrived = arrivals(traffic, steps, seed);
  auto next = arrived.begin();
  std::vector<Duration> delays;
  for (Time now = traffic.begin + warm_up; now + late_after <= traffic.end; now += period) {
    while (next != arrived.end() && next->sent < now) ++next;
    delays.push_back(next == arrived.end() ? never - now : next->at - now);
  }
  std::sort(delays.begin(), delays.end());
  const auto in_time = std::upper_bound(delays.begin(), delays.end(), late_after) - delays.begin();
  const auto all = static_cast<double>(delays.size());
  figures.unreachable = 100 * (1 - static_cast<double>(in_time) / all);
  figures.least_p99_ms = 1e3 * to_seconds(delays[static_cast<std::size_t>(0.99 * (all - 1))]);
}

}  // namespace tocsin::bench
