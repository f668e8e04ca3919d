// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/wall.hpp"
#include "radio_channel/access_category.hpp"
#include "radio_channel/channel_params.hpp"
#include "radio_channel/medium.hpp"
#include "radio_channel/outages.hpp"
#include "radio_channel/packet_loss.hpp"
#include "radio_channel/propagation.hpp"
#include "radio_channel/random.hpp"

namespace tocsin::radio {

/// uplink: from the vehicle over the air to the access point, then the wire to the ground station.
enum class Direction : std::uint8_t { uplink, downlink };

/// An IP packet to send.
struct Packet {
  int bytes;                     ///< at least 1
  bool group_addressed = false;  ///< to a multicast or broadcast address
  AccessCategory category = AccessCategory::best_effort;
};

enum class Fate : std::uint8_t { delivered, lost_in_queue, lost_on_air };

/// How a pushed packet ended. Each packet has exactly one.
struct Outcome {
  FrameId id;
  Direction direction;
  Fate fate;
  int bytes;
  AccessCategory category;
  Time at;  ///< when it arrives at the other end, or when it is given up
};

/// How packets ended. pushed = delivered + queue_drops + losses + what is still under way.
struct PacketCounts {
  std::uint64_t pushed = 0;
  std::uint64_t delivered = 0;
  std::uint64_t queue_drops = 0;
  std::uint64_t losses = 0;
};

/// Totals of one direction.
struct DirectionReport : PacketCounts {
  /// The same by the category of the packets, whether or not it has queues of its own.
  std::array<PacketCounts, access_categories.size()> categories;
  std::uint64_t bytes_pushed = 0;
  std::uint64_t bytes_delivered = 0;
  AirCounters air;
  std::size_t queued = 0;
};

/// What a Wi-Fi driver would tell about the link, and what only the model knows.
struct LinkReport {
  bool associated;       ///< a beacon or frame was heard within 0.72 s (seven beacons)
  double rssi_dbm;       ///< of the last frame heard; NaN before the first
  double rssi_mean_dbm;  ///< mean with weight 1/8; NaN before the first
  double noise_dbm;
  int quality;         ///< 0..70 as the kernel counts: clamp(rssi, -110, -40) + 110
  double busy_share;   ///< [0,1] of the time since the last report: ours and the background's
  double mean_snr_db;  ///< at the position, mean over fading
  double x_m;
  double y_m;
  DirectionReport uplink;
  DirectionReport downlink;
};

/// One Wi-Fi link between a moving station and a ground station behind an access point.
///
/// Pure and seeded: the same calls give the same outcomes. Driven by events:
/// push packets, call advance(now) at or after next_event(), then take() outcomes until empty.
/// `now` must not decrease over all calls. One thread, not copyable.
class RadioChannel {
 public:
  /// Throws ConfigError for rules across parameters (outages_s). `start` is time zero of fading,
  /// beacons and scripted outages.
  RadioChannel(const ChannelParams& params, std::vector<geometry::Wall> walls, std::uint64_t seed,
               Time start);
  RadioChannel(const RadioChannel&) = delete;
  RadioChannel& operator=(const RadioChannel&) = delete;

  /// Moves the station, in metres in the map frame. A position that is not finite or
  /// beyond 1000 km is ignored.
  void set_position(double x_m, double y_m) { propagation_.set_position(x_m, y_m); }

  /// Sends an IP packet. Group-addressed ones from the access point are not acknowledged and go
  /// once at 6 Mbit/s; from the station they are unicast to the access point. The category counts
  /// when the parameter access_categories is set.
  FrameId push(Direction direction, const Packet& packet, Time now);

  /// The next instant at which advance() has work; `never` when the link is at rest.
  [[nodiscard]] Time next_event() const {
    Time next = medium_.next_event();
    if (!wire_to_access_point_.empty()) next = std::min(next, wire_to_access_point_.front().at);
    if (!deliveries_.empty()) next = std::min(next, deliveries_.front().at);
    return next;
  }
  /// Does everything due up to and including `now`.
  void advance(Time now);
  /// Does what is due before `limit` until there is an outcome that was not taken. Returns its
  /// time, or `limit`.
  [[nodiscard]] Time advance_to_outcome(Time limit);
  /// The next outcome in order of time, empty when none is known yet.
  [[nodiscard]] std::optional<Outcome> take();
  /// What take() would give next. There must be one.
  [[nodiscard]] const Outcome& first_outcome() const { return outcomes_.front(); }

  /// Nothing is received for `length` from `now` on.
  void begin_outage(Time now, Duration length) { outages_.begin(now, length); }
  /// Replaces the parameters; packets under way stay. Scripted outages are not replaced.
  void configure(const ChannelParams& params);
  [[nodiscard]] const ChannelParams& params() const { return params_; }

  /// The state of the link; busy_share covers the time since the last call.
  [[nodiscard]] LinkReport report(Time now);
  [[nodiscard]] const Propagation& propagation() const { return propagation_; }

 private:
  struct Arrival {
    Time at;
    AirFrame frame;
  };

  [[nodiscard]] DirectionReport& totals(Direction direction);
  void count(Direction direction, AccessCategory category, std::uint64_t PacketCounts::*which);
  void push_radio(Direction direction, const AirFrame& frame, Time now);
  void push_without_mac(Direction direction, const AirFrame& frame, Time now);
  void enqueue(Direction direction, const AirFrame& frame, Time now);
  void step(Time next);
  void step_medium();
  /// Not before what was sent earlier that way.
  void deliver_at(Time at, const Outcome& outcome);
  /// When a packet has left, without MAC; `never` when the queue is full.
  [[nodiscard]] Time leaves_at(Direction direction, int bytes, Time now);
  void end(const Outcome& outcome);
  [[nodiscard]] DirectionReport direction_report(Direction direction) const;
  [[nodiscard]] double busy_share(Time now);

  ChannelParams params_;
  bool has_mac_ = true;  ///< mode radio; the other modes are pure losses
  Duration wire_delay_;
  std::vector<geometry::Wall> walls_;
  std::uint64_t site_seed_;
  std::uint64_t seed_;  ///< of this radio
  Time start_;
  Propagation propagation_;
  Outages outages_;
  Medium medium_;
  PacketLoss packet_loss_;
  FrameId next_id_ = 1;
  std::deque<Arrival> wire_to_access_point_;
  std::deque<Outcome> deliveries_;       ///< by time
  std::array<Time, 2> last_delivery_{};  ///< by direction
  std::array<Time, 2> line_free_at_{};   ///< the same, without MAC
  RandomStream jitter_;
  std::deque<Outcome> outcomes_;
  std::vector<AirResult> air_results_;
  std::array<DirectionReport, 2> totals_;
  Time reported_at_;
  Duration reported_airtime_{0};
};

/// The kernel's link quality of a signal (wext-compat.c): 0 to 70; 0 for NaN.
[[nodiscard]] int link_quality(double rssi_dbm);

}  // namespace tocsin::radio
