// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "foundation/time.hpp"
#include "radio_channel/ofdm.hpp"

namespace tocsin::radio {

/// What a station knows of its signal: the last frame heard and a mean with weight 1/8, as mac80211
/// keeps it. Both are empty (NaN) until the first frame.
class SignalTracker {
 public:
  void on_frame(double rssi_dbm);
  [[nodiscard]] double last_dbm() const { return last_dbm_; }
  [[nodiscard]] double mean_dbm() const { return mean_dbm_; }

 private:
  double last_dbm_ = not_heard;
  double mean_dbm_ = not_heard;
  static constexpr double not_heard = __builtin_nan("");
};

/// Chooses the rate of each attempt.
///
/// The highest rate that the mean SNR minus a margin carries with 10 % loss. The margin learns from
/// the first attempts alone (outer-loop link adaptation, target 10 % loss): +1 dB after a loss,
/// -1/9 dB after a success. The mean keeps it sensible for sparse traffic, the margin for heavy
/// traffic. Repeated attempts fall back: two at the rate, then lower, the last two at 6 Mbit/s.
class RateControl {
 public:
  RateControl();
  /// `mean_snr_db` may be NaN (nothing heard yet): then the lowest rate. `attempt` counts from 0.
  [[nodiscard]] int rate(double mean_snr_db, int attempt, int attempts) const;
  /// Takes the result of an attempt that `rate` named.
  void on_result(int rate, int attempt, bool acknowledged);
  [[nodiscard]] double margin_db() const { return margin_db_; }

 private:
  std::array<double, rate_count> needed_db_;
  double margin_db_ = 3;
};

}  // namespace tocsin::radio
