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

/// An IP packet to send.
struct Packet {
  int bytes;                     ///< at least 1
  bool group_addressed = false;  ///< to a multicast or broadcast address
  AccessCategory category = AccessCategory::best_effort;
  std::size_t vehicle = 0;  ///< that sends it, or to which it goes
};

enum class Fate : std::uint8_t { delivered, lost_in_queue, lost_on_air };

/// How a pushed packet ended. Each packet has exactly one.
struct Outcome {
  FrameId id;
  Direction direction;
  Fate fate;
  int bytes;
  AccessCategory category;
  std::size_t vehicle;
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
  int quality;  ///< 0..70 as the kernel counts: clamp(rssi, -110, -40) + 110
  double
      busy_share;  ///< [0,1] of the time since its last report: of all vehicles and the background
  double mean_snr_db;  ///< at the position, mean over fading
  double x_m;
  double y_m;
  DirectionReport uplink;
  DirectionReport downlink;
};

/// The Wi-Fi of one site: moving vehicles on one channel, and a ground station behind their access
/// point. All vehicles share the medium and the shadowing of a place; signal, fading, rates, delays
/// and totals are each one's own.
///
/// Pure and seeded: the same calls give the same outcomes. Driven by events:
/// push packets, call advance(now) at or after next_event(), then take() outcomes until empty.
/// `now` must not decrease over all calls. A vehicle's number is below `vehicles`, else it is
/// undefined what happens. One thread, not copyable.
class RadioChannel {
 public:
  /// Throws ConfigError for rules across parameters (outages_s). `start` is time zero of fading,
  /// beacons and scripted outages. `vehicles` is at least 1.
  RadioChannel(const ChannelParams& params, const std::vector<geometry::Wall>& walls,
               std::uint64_t seed, Time start, std::size_t vehicles = 1);
  RadioChannel(const RadioChannel&) = delete;
  RadioChannel& operator=(const RadioChannel&) = delete;

  /// Moves a vehicle, in metres in the map frame. A position that is not finite or
  /// beyond 1000 km is ignored.
  void set_position(double x_m, double y_m, std::size_t vehicle = 0) {
    vehicles_[vehicle].propagation.set_position(x_m, y_m);
  }

  /// Sends an IP packet. Group-addressed ones from the access point are not acknowledged and go
  /// once at 6 Mbit/s; from a vehicle they are unicast to the access point. The category counts
  /// when the parameter access_categories is set.
  FrameId push(Direction direction, const Packet& packet, Time now);

  /// The next instant at which advance() has work; `never` when the link is at rest.
  [[nodiscard]] Time next_event() const { return std::min(medium_.next_event(), next_waiting()); }
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

  /// The state of a vehicle's link; busy_share covers the time since the last call for it.
  [[nodiscard]] LinkReport report(Time now, std::size_t vehicle = 0);
  [[nodiscard]] const Propagation& propagation(std::size_t vehicle = 0) const {
    return vehicles_[vehicle].propagation;
  }

 private:
  struct Arrival {
    Time at;
    AirFrame frame;
  };
  /// The link of one vehicle.
  struct Vehicle {
    Vehicle(const ChannelParams& params, const std::vector<geometry::Wall>& walls,
            std::uint64_t site_seed, Time start, std::size_t number);
    Propagation propagation;
    std::uint64_t seed;
    PacketLoss packet_loss;
    RandomStream jitter;
    std::deque<Arrival> wire_to_access_point = {};
    std::deque<Outcome> deliveries = {};         ///< by time
    std::array<Time, 2> last_delivery = {};      ///< by direction
    std::array<Time, 2> line_free_at = {};       ///< the same, without MAC
    std::array<DirectionReport, 2> totals = {};  ///< the same
    Time reported_at;
    Duration reported_airtime{0};
    [[nodiscard]] Time next() const;
    [[nodiscard]] DirectionReport& totals_of(Direction direction);
  };

  [[nodiscard]] Time next_waiting() const {
    if (vehicles_.size() == 1) return vehicles_.front().next();
    Time next = never;
    for (const Vehicle& one : vehicles_) next = std::min(next, one.next());
    return next;
  }
  void count(const Outcome& outcome, std::uint64_t PacketCounts::*which);
  void push_radio(Direction direction, const AirFrame& frame, Time now);
  void push_without_mac(Direction direction, const AirFrame& frame, Time now);
  void enqueue(Direction direction, const AirFrame& frame, Time now);
  void step(Time next);
  [[nodiscard]] bool step_waiting(Vehicle& vehicle, Time next);
  void step_medium();
  /// Not before what was sent to or from this vehicle earlier.
  void deliver_at(Time at, const Outcome& outcome);
  /// When a packet has left, without MAC; `never` when the queue is full.
  [[nodiscard]] Time leaves_at(Direction direction, const AirFrame& frame, Time now);
  void end(const Outcome& outcome);
  [[nodiscard]] DirectionReport direction_report(std::size_t vehicle, Direction direction) const;
  [[nodiscard]] double busy_share(Vehicle& vehicle, Time now) const;
  [[nodiscard]] std::vector<Propagation*> propagations();

  ChannelParams params_;
  bool has_mac_ = true;  ///< mode radio; the other modes are pure losses
  Duration wire_delay_;
  std::vector<geometry::Wall> walls_;
  std::uint64_t site_seed_;
  Time start_;
  std::deque<Vehicle> vehicles_;  ///< which stay where they are
  Outages outages_;
  Medium medium_;
  FrameId next_id_ = 1;
  std::deque<Outcome> outcomes_;
  std::vector<AirResult> air_results_;
};

/// The kernel's link quality of a signal (wext-compat.c): 0 to 70; 0 for NaN.
[[nodiscard]] int link_quality(double rssi_dbm);

}  // namespace tocsin::radio
