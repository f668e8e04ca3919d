// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "radio_channel/access_category.hpp"
#include "radio_channel/channel_params.hpp"
#include "radio_channel/contention.hpp"
#include "radio_channel/frame_queue.hpp"
#include "radio_channel/ofdm.hpp"
#include "radio_channel/outages.hpp"
#include "radio_channel/propagation.hpp"
#include "radio_channel/random.hpp"
#include "radio_channel/rate_control.hpp"

namespace tocsin::radio {

/// uplink: from a vehicle over the air to the access point, then the wire to the ground station.
enum class Direction : std::uint8_t { uplink, downlink };

/// What became of a frame on the air, told once: when it is received or given up.
struct AirResult {
  FrameId id;
  int bytes;
  AccessCategory category;
  std::size_t vehicle;
  Direction direction;
  bool received;
  bool expired;  ///< it was given up because it had waited too long
  Time at;
};

/// Totals of what was sent between a vehicle and the access point, one way.
struct AirCounters {
  std::uint64_t attempts = 0;
  std::uint64_t retries = 0;  ///< attempts after the first of a frame
  std::uint64_t failed = 0;   ///< frames given up without acknowledgement
  Duration airtime{0};        ///< of data frames and acknowledgements
};

/// Vehicles and an access point of 802.11g that share one channel by the distributed coordination
/// function: backoff, collisions, retries with rate fall-back, lost acknowledgements, background
/// stations. All hear when another one sends. Events happen at next_event(); call step() then.
///
/// With access categories (802.11e, EDCA) each station has a queue for each, which contends for
/// the medium by itself; when two of a station are due in the same slot, the more urgent one sends
/// and the other backs off as after a collision. Then no attempt of it is counted.
class Medium {
 public:
  /// `vehicles`: the way of each one to the access point, at least one; they and `outages` must
  /// outlive the medium. Fading continues from `start`.
  Medium(const ChannelParams& params, const std::vector<Propagation*>& vehicles,
         const Outages& outages, std::uint64_t seed, Time start);

  /// Appends a frame to the queue of its category, or to the only one; the access point has one for
  /// each vehicle. False when it is full.
  /// `now` must not be later than next_event().
  [[nodiscard]] bool enqueue(Direction direction, const AirFrame& frame, Time now);
  [[nodiscard]] Time next_event() const { return busy_ ? busy_until_ : access_at_; }
  /// Does what is due at next_event(), appends what ended to `results`.
  void step(std::vector<AirResult>& results);

  /// New settings for what is sent from now on.
  void configure(const ChannelParams& params);
  /// A vehicle hears the beacons (every 102.4 ms) that were due up to `now`; at most the last
  /// eight.
  void hear_beacons(std::size_t vehicle, Time now);

  [[nodiscard]] const AirCounters& counters(std::size_t vehicle, Direction direction) const {
    return links_[vehicle].ways[index_of(direction)].counters;
  }
  /// Of all vehicles, both ways.
  [[nodiscard]] Duration airtime() const;
  /// Frames in all queues of a vehicle, or for it in those of the access point.
  [[nodiscard]] std::size_t queued(std::size_t vehicle, Direction direction) const;
  [[nodiscard]] const SignalTracker& signal(std::size_t vehicle) const {
    return links_[vehicle].signal;
  }
  /// Time since a vehicle and the access point last heard a frame or beacon of each other.
  [[nodiscard]] Duration silence(std::size_t vehicle, Time now) const {
    return now - links_[vehicle].heard_at;
  }

 private:
  /// What is sent one way between a vehicle and the access point.
  struct AirWay {
    RateControl rates;
    AirCounters counters;
  };
  struct AirLink {
    Propagation* propagation;
    SignalTracker signal = {};
    std::array<AirWay, 2> ways = {};  ///< by direction
    Time beacon_at = {};
    Time heard_at = {};
  };
  /// A queue with its backoff.
  struct Contender {
    std::size_t station = 0;  // a vehicle, or all of them: the access point
    Duration idle_time{0};    // that the medium must be idle before its slots count down
    int cw_min = 0;
    int cw_max = 0;
    bool single = false;  // the queue without access categories; what it waits for others is slots
    FrameQueue queue = FrameQueue(1);
    int window = 0;
    std::optional<int> backoff = {};  // slots left from a contention that another one won
    Time ready = never;               // when its backoff ends
    Time counts_from = Time::min();   // when its slots begin to count down
    int rate = 0;                     // of the attempt under way
    bool sending = false;
    bool data_received = false;
    bool acknowledged = false;
  };

  [[nodiscard]] static std::size_t index_of(Direction direction) {
    return direction == Direction::uplink ? 0 : 1;
  }
  /// Of all vehicles and the access point.
  [[nodiscard]] std::size_t stations() const { return links_.size() + 1; }
  [[nodiscard]] Direction direction_of(const Contender& contender) const {
    return contender.station < links_.size() ? Direction::uplink : Direction::downlink;
  }
  /// Which of a station's queues has the frames for a vehicle.
  [[nodiscard]] std::size_t receiver_of(const Contender& contender, std::size_t vehicle) const {
    return contender.station < links_.size() ? 0 : vehicle;
  }
  [[nodiscard]] Contender& contender_of(std::size_t station, AccessCategory category);
  [[nodiscard]] AirWay& way_of(const Contender& contender) {
    return links_[contender.queue.front().vehicle].ways[index_of(direction_of(contender))];
  }
  [[nodiscard]] int rate_of(const Contender& contender);
  [[nodiscard]] bool heard(const AirLink& link, int rate, int bytes, Time now);
  void set(const ChannelParams& params);
  static void hear_frame(AirLink& link, Time now);
  void join(Contender& one, Time now);
  void contend(Time now, Duration occupied);
  void schedule_access();
  void start_transmissions();
  void find_winners(Time now);
  [[nodiscard]] Duration transmit(Contender& one, Time now, bool collided);
  void finish(Contender& one, std::vector<AirResult>& results);
  /// Gives up what has waited too long.
  void expire(Contender& one, Time now, std::vector<AirResult>& results);
  void retry(Contender& one);
  void end_frame(Contender& one);

  const Outages& outages_;
  const FrameErrorTable& errors_;
  RandomStream random_;
  BackgroundLoad background_;
  std::vector<AirLink> links_;  ///< by vehicle
  /// First one of each station, which without access categories are all that is used. They stay
  /// apart from the others, so that switching the categories on or off leaves queued frames where
  /// they are.
  std::vector<Contender> contenders_;
  std::vector<Contender*> winners_;  ///< by station; null: it sends nothing
  std::size_t used_;                 ///< of the contenders; more after the categories were on
  bool access_categories_ = false;
  int attempts_;
  int fixed_rate_ = -1;  ///< below 0: the rate control chooses
  std::size_t queue_frames_;
  Duration frame_lifetime_{0};  ///< zero: for ever
  double noise_dbm_;
  double snr_offset_db_;
  bool busy_ = false;
  Time busy_until_ = never;
  Duration occupied_{0};  // length of the transmission under way
  Time access_at_ = never;
  Time idle_since_;
};

}  // namespace tocsin::radio
