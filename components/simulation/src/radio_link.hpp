// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::simulation {

/// The other way.
[[nodiscard]] inline radio::Direction back(radio::Direction direction) {
  return direction == radio::Direction::uplink ? radio::Direction::downlink
                                               : radio::Direction::uplink;
}

/// What goes wrong on the air besides what the channel does.
struct AirFaults {
  double loss = 0;         ///< [0, 1]
  double duplication = 0;  ///< [0, 1]
  double delay_s = 0;      ///< up to so much more, each packet on its own
  [[nodiscard]] bool any() const { return loss > 0 || duplication > 0 || delay_s > 0; }
};

/// Carries packets between the vehicle and the ground station: one radio_channel for all.
class RadioLink {
 public:
  using Arrival = std::function<void()>;
  RadioLink(Core& core, const radio::ChannelParams& params, std::vector<radio::Wall> walls,
            std::uint64_t seed);

  /// Sends an IP packet; `on_arrival` runs when and if it comes to the other side.
  void send(radio::Direction direction, std::size_t ip_bytes, Arrival on_arrival);
  [[nodiscard]] Time next_event() const { return sent_ ? core_.now : channel_.next_event(); }
  /// Does what is due at the core's time.
  void advance();
  /// From now on; may be changed at any time.
  [[nodiscard]] AirFaults& faults() { return faults_; }

  void set_position(double x_m, double y_m) { channel_.set_position(x_m, y_m); }
  /// The text of /proc/net/wireless on the vehicle, renewed each second as by the link emulator.
  [[nodiscard]] const std::string& wireless_text() const { return wireless_text_; }
  [[nodiscard]] std::uint64_t pushed() const { return next_ - 1; }

 private:
  void report();
  void carry(const Arrival& arrival);
  [[nodiscard]] double share();
  Core& core_;
  radio::RadioChannel channel_;
  std::deque<Arrival> under_way_;  ///< packets first_ to next_ - 1; empty when it has ended
  radio::FrameId first_ = 1;
  radio::FrameId next_ = 1;
  AirFaults faults_;
  std::mt19937_64 random_;  ///< of the faults
  bool sent_ = false;       ///< since the last advance: outcomes may wait
  std::string wireless_text_;
};

}  // namespace tocsin::simulation
