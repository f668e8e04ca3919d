// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/discovery_pacer.hpp"

#include <algorithm>

namespace tocsin {
namespace {

/// States that are remembered before idle ones are forgotten: more than three per peer.
constexpr std::size_t most_states = 64;

Duration period_of(const StateKey& key) {
  constexpr std::uint8_t heartbeat = 0x07;
  return key[0] == heartbeat ? DiscoveryPacer::heartbeat_period
                             : DiscoveryPacer::acknowledgement_period;
}

}  // namespace

bool DiscoveryPacer::passes(const StateKey& key, const Held& message, Time now) {
  if (states_.size() > most_states) forget_idle(now);
  State& state = states_[{key, message.to}];
  if (now < state.next) {
    state.held = message;
    return false;
  }
  state.held.reset();
  state.next = now + period_of(key);
  return true;
}

std::optional<DiscoveryPacer::Held> DiscoveryPacer::take_due(Time now) {
  for (auto& [key, state] : states_) {
    if (!state.held || now < state.next) continue;
    state.next = now + period_of(key.first);
    return std::exchange(state.held, std::nullopt);
  }
  return std::nullopt;
}

Time DiscoveryPacer::deadline() const {
  Time next = never;
  for (const auto& entry : states_) {
    if (entry.second.held) next = std::min(next, entry.second.next);
  }
  return next;
}

void DiscoveryPacer::forget_idle(Time now) {
  for (auto it = states_.begin(); it != states_.end();) {
    const bool idle = !it->second.held && now >= it->second.next;
    it = idle ? states_.erase(it) : std::next(it);
  }
}

}  // namespace tocsin
