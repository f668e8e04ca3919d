// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "link_router/link_constants.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// The least value of the last window, kept in two halves: it forgets after one to two halves.
class WindowedMinimum {
 public:
  explicit WindowedMinimum(Duration window) : half_(window / 2) {}
  void add(Duration value, Time now);
  /// Empty before the first value.
  [[nodiscard]] std::optional<Duration> value() const;
  void clear() { *this = WindowedMinimum(2 * half_); }
  /// Time in which no value was possible does not count.
  void skip(Duration silence) { begin_ += silence; }

 private:
  Duration half_;
  Time begin_{};
  std::optional<Duration> current_;
  std::optional<Duration> previous_;
};

/// Mean and deviation of times, smoothed (RFC 6298, 2.3).
class SmoothedTime {
 public:
  void add(Duration time);
  /// What is not later than this is in time: the mean and four deviations. [s]
  [[nodiscard]] double bound_s() const { return mean_s_ + 4 * deviation_s_; }

 private:
  double mean_s_ = 0;
  double deviation_s_ = 0;
};

/// What one peer's acknowledgements say of the way to it: capacity, queueing delay, loss, silence.
///
/// Model: the radio's queue is a line that drains at the capacity. What is sent adds to it; what
/// comes corrects it. Capacity is learned from bulk alone (a sample of many packets, which the
/// radio sends one after the other): its bytes over the time from its turn to its arrival, where
/// its turn is its sending or the arrival of the bulk before it, whichever is later. A shrinking
/// capacity is believed faster than a growing one. Bulk in pieces is one measurement, which each
/// exact arrival of a later piece makes better. Delays are over the least one in the clock
/// window, so that the clocks need not agree, and a step of a clock is forgotten with the window.
/// Pure; `now` never decreases.
class LinkEstimator {
 public:
  LinkEstimator() = default;
  /// `phase` in [0, 1) sets it apart from others on the same air, see on_sent().
  explicit LinkEstimator(double phase) : phase_(phase) {}

  /// Something goes to the radio, and counts in the share of the air or not. Returns when the model
  /// has it leave. What is spent of a share counts a half to one and a half, one on average: equal
  /// shares of equal samples would else be spent at the same instants for ever.
  Time on_sent(const WireCost& cost, Time now, bool of_share = true);

  /// A transmission that was received.
  struct Received {
    WireCost cost;
    Time sent{};
    Time expected{};          ///< what on_sent() returned
    Time arrived{};           ///< by the peer's clock
    bool is_exact = true;     ///< else it arrived then or before: nothing is learned of times
    std::uint64_t burst = 0;  ///< not 0: `cost` is of the pieces that left together, up to this one
  };
  /// Returns its delay over the least one, at least zero.
  Duration on_received(const Received& received, Time now);
  /// A transmission that is lost.
  void on_lost();

  /// [B/s] What waits for the radio waits for this, too, whatever is measured: the use of the path
  /// is metered. At least 1.
  void set_limit(double bytes_per_s) { limit_bytes_per_s_ = bytes_per_s; }
  /// (0, 1] of the air for this way; empty: all of it. What is sent of the share makes others that
  /// wait for the radio wait for the share, too.
  void set_airtime_share(std::optional<double> share) { airtime_share_ = share; }

  /// [B/s]
  [[nodiscard]] double capacity_bytes_per_s() const {
    return std::min(capacity_bytes_per_s_, limit_bytes_per_s_);
  }
  /// [B/s] of the way while nobody else sends: the fastest bulk of the last ten seconds; before it
  /// was measured, what the lowest rate of 802.11g leaves.
  [[nodiscard]] double free_bytes_per_s() const;
  /// [B/s] that the share of the air carries; infinite without one.
  [[nodiscard]] double share_bytes_per_s() const;
  /// From sending, by this clock, to arrival, by the peer's: the least of a small sample lately.
  [[nodiscard]] std::optional<Duration> least_crossing() const { return least_.value(); }
  /// Whether it was ever measured on bulk; else it is only assumed.
  [[nodiscard]] bool is_capacity_measured() const { return is_capacity_measured_; }
  /// How long what is sent at `now` would wait in the radio, or for its share of the air.
  [[nodiscard]] Duration backlog(Time now) const;
  /// The share of the air is used up at `now`.
  [[nodiscard]] bool waits_for_share(Time now) const { return share_used_ > now; }
  /// The wait that a small sample must reckon with before an acknowledgement can name it: recent
  /// delays with their spread.
  [[nodiscard]] Duration expected_delay() const;
  /// From a small sample to its acknowledgement lately, with its spread (RFC 6298), at most
  /// `answer_max_s`. Where others share the air, both ways wait for them, whatever is sent here.
  [[nodiscard]] Duration expected_answer() const;
  /// [0, 1] recent share that was lost.
  [[nodiscard]] double loss() const { return loss_; }
  /// Nothing has been acknowledged for so long that the link counts as dead.
  [[nodiscard]] bool is_silent(Time now, Duration after = silent_after) const;
  /// This process was frozen until `now`. Of what was sent before nobody knows when it left, so
  /// that its arrival tells nothing of times; and nobody was here to hear that the peer lives.
  void on_frozen(Time now);
  /// Nothing that was sent waits for an acknowledgement.
  void on_all_settled() { waiting_since_.reset(); }
  /// The link is back: what was learned of its queue is void, what was measured of its capacity
  /// since the last time halved.
  void start_over(Time now);

 private:
  void learn_capacity(const Received& received, Time arrived);

  WindowedMinimum least_{
      clock_window};  ///< of small samples: by the peer's clock, from sending to arrival
  WindowedMinimum per_kilobyte_{airtime_window};  ///< of bulk: the least time of a thousand bytes
  std::optional<double> airtime_share_;
  double limit_bytes_per_s_ = std::numeric_limits<double>::infinity();
  double capacity_bytes_per_s_ = capacity_start_bytes_per_s;
  bool is_capacity_measured_ = false;
  bool measured_ = false;  ///< the capacity, since the last start_over()
  double loss_ = 0;
  SmoothedTime delay_;   ///< of small samples, over the least
  SmoothedTime answer_;  ///< from their sending to their acknowledgement
  Time drained_{};       ///< when the model's queue is empty
  Time paid_{};          ///< until then the limit is used up
  Time share_used_{};    ///< until then the share of the air is used up
  Time spent_at_{};      ///< the last time that something was
  double phase_ = 0;     ///< [0, 1) of what was spent then
  struct Measurement {
    std::uint64_t burst = 0;
    Time turn{};                    ///< of its bulk in the radio
    double before_bytes_per_s = 0;  ///< the capacity as it was believed before
    Duration behind{0};             ///< the model's queue, as far as that is mended
    std::optional<Duration> per_kilobyte;
  };
  Measurement last_{};
  Time bulk_arrived_{};                ///< by our clock, as if the least delay were zero
  Time frozen_{};                      ///< until then, the last time
  std::optional<Time> waiting_since_;  ///< something sent since then, nothing acknowledged
  int unanswered_ = 0;                 ///< transmissions since the last that was acknowledged
};

}  // namespace tocsin::router
