// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
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
  int bytes;              ///< of the IP packet
  bool acknowledged;      ///< false: group-addressed from the access point, one try, 6 Mbit/s
  int attempt = 0;        ///< transmissions so far
  bool received = false;  ///< the receiver has it (its acknowledgement may have been lost)
};

/// What became of a frame on the air, told once: when it is received or given up.
struct AirResult {
  FrameId id;
  int bytes;
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
class Medium {
 public:
  /// `propagation` and `outages` must outlive the medium. Fading continues from `start`.
  Medium(const ChannelParams& params, Propagation& propagation, const Outages& outages,
         std::uint64_t seed, Time start);

  /// Appends a frame; false when the queue is full. `now` must not be later than next_event().
  [[nodiscard]] bool enqueue(int station, const AirFrame& frame, Time now);
  [[nodiscard]] Time next_event() const { return busy_ ? busy_until_ : access_at_; }
  /// Does what is due at next_event(), appends what ended to `results`.
  void step(std::vector<AirResult>& results);

  /// New settings for what is sent from now on.
  void configure(const ChannelParams& params);
  /// Hears the beacons (every 102.4 ms) that were due up to `now`; at most the last eight.
  void hear_beacons(Time now);

  [[nodiscard]] const AirCounters& counters(int station) const { return side(station).counters; }
  [[nodiscard]] std::size_t queued(int station) const { return side(station).queue.size(); }
  [[nodiscard]] const SignalTracker& signal() const { return signal_; }
  /// Time since the last frame or beacon was heard.
  [[nodiscard]] Duration silence(Time now) const { return now - heard_at_; }

 private:
  struct Side {
    std::deque<AirFrame> queue;
    RateControl rates;
    AirCounters counters;
    int window = cw_min;
    std::optional<int> backoff;  // slots left from a contention that the other station won
    Time ready = never;          // when its backoff ends
    int rate = 0;                // of the attempt under way
    bool sending = false;
    bool data_received = false;
    bool acknowledged = false;
  };

  [[nodiscard]] Side& side(int station) { return sides_[static_cast<std::size_t>(station)]; }
  [[nodiscard]] const Side& side(int station) const {
    return sides_[static_cast<std::size_t>(station)];
  }
  [[nodiscard]] bool heard(int rate, int bytes, Time now);
  void set(const ChannelParams& params);
  void hear_frame(Time now);
  void join(Side& side, Time now);
  void contend(Time now, Duration occupied);
  void schedule_access();
  void start_transmissions();
  [[nodiscard]] Duration transmit(Side& side, Time now, bool collided);
  void finish(int station, std::vector<AirResult>& results);
  void retry(Side& side);
  void end_frame(Side& side);

  Propagation& propagation_;
  const Outages& outages_;
  const FrameErrorTable& errors_;
  RandomStream random_;
  BackgroundLoad background_;
  SignalTracker signal_;
  std::array<Side, 2> sides_;
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
