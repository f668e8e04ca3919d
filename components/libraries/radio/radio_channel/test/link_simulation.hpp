// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>

#include "radio_channel/radio_channel.hpp"

namespace tocsin::radio {

/// A place with this mean SNR, no shadowing, and Rician factor `k_db`.
inline ChannelParams place(double snr_db, double k_db) {
  ChannelParams params;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = k_db;
  params.tx_dbm = 0;
  params.loss_at_1m_db = 40;
  params.noise_dbm = -40 - snr_db;  // the station stays at the origin, 1 m by definition
  return params;
}

/// Drives a channel in virtual time and tells how each packet ended.
class LinkSimulation {
 public:
  explicit LinkSimulation(const ChannelParams& params, std::uint64_t seed = 1)
      : channel(params, {}, seed, Time{}) {}

  FrameId push(Direction direction, int bytes, double at_s, bool group = false) {
    return push(direction, Packet{bytes, group}, at_s);
  }
  FrameId push(Direction direction, const Packet& packet, double at_s) {
    const FrameId id = channel.push(direction, packet, Time{} + seconds(at_s));
    collect();
    return id;
  }
  void run_until(double at_s) {
    channel.advance(Time{} + seconds(at_s));
    collect();
  }
  /// Until nothing is under way.
  void finish() {
    while (channel.next_event() != never) {
      channel.advance(channel.next_event());
      collect();
    }
  }
  [[nodiscard]] int count(Fate fate) const {
    int sum = 0;
    for (const auto& [id, outcome] : outcomes) sum += outcome.fate == fate ? 1 : 0;
    return sum;
  }

  RadioChannel channel;
  std::map<FrameId, Outcome> outcomes;
  int repeated = 0;  ///< outcomes of packets that had ended before

 private:
  void collect() {
    while (const auto outcome = channel.take()) {
      repeated += outcomes.emplace(outcome->id, *outcome).second ? 0 : 1;
    }
  }
};

/// Share of pings of 92 bytes, one every 0.3 s for `length_s`, that come back.
inline double ping_loss(const ChannelParams& params, std::uint64_t seed, double length_s) {
  LinkSimulation link(params, seed);
  int lost = 0;
  int sent = 0;
  for (double t_s = 0; t_s < length_s; t_s += 0.3, ++sent) {
    const FrameId request = link.push(Direction::uplink, 92, t_s);
    link.finish();
    const Outcome there = link.outcomes.at(request);
    if (there.fate != Fate::delivered) {
      ++lost;
      continue;
    }
    const FrameId reply = link.channel.push(Direction::downlink, {92}, there.at);
    link.finish();
    lost += link.outcomes.at(reply).fate != Fate::delivered ? 1 : 0;
  }
  return static_cast<double>(lost) / sent;
}

}  // namespace tocsin::radio
