// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "radio_channel/access_category.hpp"
#include "radio_channel/channel_params.hpp"
#include "radio_channel/contention.hpp"
#include "radio_channel/ofdm.hpp"
#include "radio_channel/outages.hpp"
#include "radio_channel/propagation.hpp"
#include "radio_channel/random.hpp"
#include "radio_channel/rate_control.hpp"

namespace tocsin::radio {

using FrameId = std::uint64_t;

/// One unit of work for the MAC.
struct AirFrame {
  FrameId id;
  int bytes;          ///< of the IP packet
  bool acknowledged;  ///< false: group-addressed from the access point, one try, 6 Mbit/s
  AccessCategory category = AccessCategory::best_effort;
  int attempt = 0;        ///< transmissions so far
  bool received = false;  ///< the receiver has it (its acknowledgement may have been lost)
};

/// What became of a frame on the air, told once: when it is received or given up.
struct AirResult {
  FrameId id;
  int bytes;
  AccessCategory category;
  int station;
  bool received;
  Time at;
};

/// Totals of one station.
struct AirCounters {
  std::uint64_t attempts = 0;
  std::uint64_t retries = 0;  ///< attempts after the first of a frame
  std::uint64_t failed = 0;   ///< frames given up without acknowledgement
  Duration airtime{0};        ///< of data frames and acknowledgements
};

/// Two stations of 802.11g (0 the vehicle, 1 the access point) that share one channel by the
/// distributed coordination function: backoff, collisions, retries with rate fall-back, lost
/// acknowledgements, background stations. Events happen at next_event(); call step() then.
///
/// With access categories (802.11e, EDCA) each station has a queue for each, which contends for
/// the medium by itself; when two of a station are due in the same slot, the more urgent one sends
/// and the other backs off as after a collision. Then no attempt of it is counted.
class Medium {
 public:
  /// `propagation` and `outages` must outlive the medium. Fading continues from `start`.
  Medium(const ChannelParams& params, Propagation& propagation, const Outages& outages,
         std::uint64_t seed, Time start);

  /// Appends a frame to the queue of its category, or to the only one; false when that is full.
  /// `now` must not be later than next_event().
  [[nodiscard]] bool enqueue(int station, const AirFrame& frame, Time now);
  [[nodiscard]] Time next_event() const { return busy_ ? busy_until_ : access_at_; }
  /// Does what is due at next_event(), appends what ended to `results`.
  void step(std::vector<AirResult>& results);

  /// New settings for what is sent from now on.
  void configure(const ChannelParams& params);
  /// Hears the beacons (every 102.4 ms) that were due up to `now`; at most the last eight.
  void hear_beacons(Time now);

  [[nodiscard]] const AirCounters& counters(int station) const {
    return stations_[static_cast<std::size_t>(station)].counters;
  }
  /// Frames in all queues of a station.
  [[nodiscard]] std::size_t queued(int station) const;
  [[nodiscard]] const SignalTracker& signal() const { return signal_; }
  /// Time since the last frame or beacon was heard.
  [[nodiscard]] Duration silence(Time now) const { return now - heard_at_; }

 private:
  /// What its queues share.
  struct Station {
    RateControl rates;
    AirCounters counters;
  };
  /// A queue with its backoff.
  struct Contender {
    int station = 0;
    Duration idle_time{0};  // that the medium must be idle before its slots count down
    int cw_min = 0;
    int cw_max = 0;
    bool single = false;  // the queue without access categories; what it waits for others is slots
    std::deque<AirFrame> queue;
    int window = 0;
    std::optional<int> backoff;      // slots left from a contention that another one won
    Time ready = never;              // when its backoff ends
    Time counts_from = Time::min();  // when its slots begin to count down
    int rate = 0;                    // of the attempt under way
    bool sending = false;
    bool data_received = false;
    bool acknowledged = false;
  };
  /// Without access categories only the first two are in use: one for each station. They stay
  /// apart from the others, so that switching the categories on or off leaves queued frames where
  /// they are.
  static constexpr std::size_t singles = 2;
  static constexpr std::size_t all_contenders = singles + 2 * access_categories.size();

  [[nodiscard]] Contender& contender_of(int station, AccessCategory category);
  [[nodiscard]] Station& station_of(const Contender& contender) {
    return stations_[static_cast<std::size_t>(contender.station)];
  }
  [[nodiscard]] bool heard(int rate, int bytes, Time now);
  void set(const ChannelParams& params);
  void hear_frame(Time now);
  void join(Contender& one, Time now);
  void contend(Time now, Duration occupied);
  void schedule_access();
  void start_transmissions();
  [[nodiscard]] std::array<Contender*, 2> winners(Time now);
  [[nodiscard]] Duration transmit(Contender& one, Time now, bool collided);
  void finish(Contender& one, std::vector<AirResult>& results);
  void retry(Contender& one);
  void end_frame(Contender& one);

  Propagation& propagation_;
  const Outages& outages_;
  const FrameErrorTable& errors_;
  RandomStream random_;
  BackgroundLoad background_;
  SignalTracker signal_;
  std::array<Station, 2> stations_;
  std::array<Contender, all_contenders> contenders_;
  std::size_t used_ = singles;  // of them; more after the categories were on
  bool access_categories_ = false;
  int attempts_;
  std::size_t queue_frames_;
  double noise_dbm_;
  double snr_offset_db_;
  bool busy_ = false;
  Time busy_until_ = never;
  Duration occupied_{0};  // length of the transmission under way
  Time access_at_ = never;
  Time idle_since_;
  Time beacon_at_;
  Time heard_at_;
};

}  // namespace tocsin::radio
