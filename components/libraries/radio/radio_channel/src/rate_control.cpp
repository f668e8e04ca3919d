// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/rate_control.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::radio {
namespace {

constexpr double target = 0.1;
constexpr double step_db = 1;
constexpr double most_margin_db = 12;
constexpr int reference_bytes = 1500;
constexpr std::size_t slow_rates = 1;  // 9 Mbit/s needs as much SNR as 12 and is never chosen

std::array<double, rate_count> needed_snr() {
  std::array<double, rate_count> needed{};
  for (int rate = 0; rate < rate_count; ++rate) {
    needed[static_cast<std::size_t>(rate)] = snr_for_error_db(rate, reference_bytes, target);
  }
  return needed;
}

}  // namespace

void SignalTracker::on_frame(double rssi_dbm) {
  last_dbm_ = rssi_dbm;
  mean_dbm_ = std::isnan(mean_dbm_) ? rssi_dbm : mean_dbm_ + (rssi_dbm - mean_dbm_) / 8;
}

RateControl::RateControl() {
  static const std::array<double, rate_count> needed = needed_snr();
  needed_db_ = needed;
}

int RateControl::rate(double mean_snr_db, int attempt, int attempts) const {
  if (attempts > 2 && attempt >= attempts - 2) return 0;
  int best = 0;
  for (std::size_t i = rate_count - 1; i > slow_rates && best == 0; --i) {
    if (mean_snr_db - margin_db_ >= needed_db_[i]) best = static_cast<int>(i);
  }
  const int lower = best - (attempt < 2 ? 0 : attempt - 1);
  return lower > static_cast<int>(slow_rates) ? lower : 0;
}

void RateControl::on_result(int rate, int attempt, bool acknowledged) {
  if (attempt != 0) return;
  if (acknowledged) {
    margin_db_ = std::max(0.0, margin_db_ - step_db * target / (1 - target));
  } else if (rate > 0) {
    margin_db_ = std::min(most_margin_db, margin_db_ + step_db);
  }
}

}  // namespace tocsin::radio
