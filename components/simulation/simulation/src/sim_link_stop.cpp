// SPDX-License-Identifier: Apache-2.0
// The emergency stop's way over a simulated link, as StopChannel has it on the real one.
#include "sim_link_bus.hpp"
#include "stop_bytes.hpp"

namespace tocsin::simulation {
namespace {

constexpr std::size_t ip_udp_rtps_bytes = 28 + 20;
constexpr std::uint8_t stop_dscp = 48;  // CS6
/// A changed value goes alone so often more, so far apart.
constexpr int repeats_of_change = 3;
constexpr Duration repeat_period = std::chrono::milliseconds(15);

}  // namespace

std::size_t stop_bytes(const StopValue& value) {
  constexpr std::size_t fixed = 4 + 3 + 1 + 1 + 3 * 8 + 1 + 1 + 1 + 1;  // as to_bytes has it
  std::size_t bytes =
      fixed + value.host.size() + sizeof(StopToken) * (value.locks.size() + value.keys.size());
  for (const std::string& name : value.by) bytes += 1 + name.size();
  if (!value.site.empty()) bytes += 1 + value.site.size();
  return (bytes + 3) / 4 * 4;
}

std::shared_ptr<const StopValue> SimLinkBus::rider() const {
  return stop_ && network_.core.now - stop_said_ < stop_value_lives ? stop_ : nullptr;
}

void SimLinkBus::say_stop(const StopValue& value) {
  auto named = std::make_shared<StopValue>(value);
  named->host = host_.name();
  const bool is_new = !rider() || !says_the_same(*stop_, *named);
  stop_ = std::move(named);
  stop_said_ = network_.core.now;
  if (!is_new) return;
  send_stop(Duration::zero());
  for (int i = 1; i <= repeats_of_change; ++i) {
    network_.core.events.at(network_.core.now + i * repeat_period,
                            [&network = network_, own = life_] {
                              SimLinkBus* const self = network.find_router(own);
                              if (self != nullptr) self->send_stop(Duration::zero());
                            });
  }
}

void SimLinkBus::send_stop(Duration period) {
  const auto stop = rider();
  if (!stop || process_.is_frozen()) return;
  for (PathIndex path = 0; path < paths(); ++path) {
    if (network_.core.now - stop_sent_[path] >= period) send_stop(path, stop);
  }
}

void SimLinkBus::send_stop(PathIndex path, const std::shared_ptr<const StopValue>& stop) {
  if (network_.on_air) network_.on_air({life_, 0, 0, {}, {}, stop});
  const std::size_t bytes = ip_udp_rtps_bytes + stop_bytes(*stop);
  for (const auto& entry : network_.routers) {
    if (!is_peer(*entry.second)) continue;
    radio(path).send({host_.direction(), stop_dscp, network_.vehicle}, bytes,
                     [&network = network_, own = life_, other = entry.second->life_, stop] {
                       SimLinkBus* const to = network.find_router(other);
                       if (to != nullptr) to->on_packet(own, stop);
                     });
    packets_.add_stop(bytes, true);
    note_bytes(path, bytes);
  }
  stop_sent_[path] = network_.core.now;
}

void SimLinkBus::repeat_stop() {
  send_stop(stop_value_period);
  network_.core.events.at(network_.core.now + stop_value_period,
                          [&network = network_, own = life_] {
                            SimLinkBus* const self = network.find_router(own);
                            if (self != nullptr) self->repeat_stop();
                          });
}

void SimLinkBus::on_packet(PeerId peer, const std::shared_ptr<const StopValue>& rider) {
  if (process_.is_frozen()) return;
  auto& packets = stop_news_.packets;
  if (packets.empty() || packets.back().router != peer) packets.push_back({peer, {}});
  packets.back().received = network_.core.now;
  if (!rider) return;
  std::uint64_t& last = stop_numbers_[peer];
  if (last == rider->number) return;
  last = rider->number;
  const bool is_new =
      stop_news_.values.empty() || !says_the_same(stop_news_.values.back().value, *rider);
  stop_news_.values.push_back({*rider, peer, "", network_.core.now});
  if (is_new) on_event_();
}

}  // namespace tocsin::simulation
