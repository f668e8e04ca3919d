// SPDX-License-Identifier: Apache-2.0
#include "link_map/loss_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tocsin::link_map {
namespace {

constexpr double foreign_share = 0.1;  // of readings, whose loss the signal does not explain
constexpr double usual_half_dbm = -82;
constexpr double usual_half_deviation_db = 8;
constexpr double usual_width_db = 2.5;
constexpr double width_deviation = 0.47;  // of its logarithm, a factor of 1.6
constexpr std::size_t lowest_dbm = 120;

/// Readings of one dB.
struct Bin {
  double lost = 0;
  double passed = 0;
};
using Bins = std::array<Bin, lowest_dbm + 1>;  // by -dBm

Bins bins_of(const std::vector<Reading>& readings) {
  Bins bins{};
  for (const Reading& reading : readings) {
    const double lost = reading.lost_share;
    const double below = std::round(-reading.signal_dbm);
    if (!(lost >= 0 && lost <= 1 && below >= 0 && below <= double{lowest_dbm})) continue;
    Bin& bin = bins[static_cast<std::size_t>(below)];
    bin.lost += lost;
    bin.passed += 1 - lost;
  }
  return bins;
}

double square(double x) { return x * x; }

double log_posterior(const LossCurve& curve, const Bins& bins) {
  double sum = -0.5 * (square((curve.half_dbm - usual_half_dbm) / usual_half_deviation_db) +
                       square(std::log(curve.width_db / usual_width_db) / width_deviation));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].lost + bins[i].passed == 0) continue;
    const double lost =
        foreign_share / 2 + (1 - foreign_share) * curve.lost_share(-static_cast<double>(i));
    sum += bins[i].lost * std::log(lost) + bins[i].passed * std::log(1 - lost);
  }
  return sum;
}

}  // namespace

double LossCurve::lost_share(double signal_dbm) const {
  return 1 / (1 + std::exp((signal_dbm - half_dbm) / width_db));
}

LossCurve fit_loss_curve(const std::vector<Reading>& readings) {
  const Bins bins = bins_of(readings);
  LossCurve best{usual_half_dbm, usual_width_db};
  double most = log_posterior(best, bins);
  for (const double width_db : {1.0, 1.6, 2.5, 4.0, 6.3}) {
    for (double half_dbm = -110; half_dbm <= -50; half_dbm += 0.5) {
      const LossCurve curve{half_dbm, width_db};
      const double likely = log_posterior(curve, bins);
      if (likely <= most) continue;
      most = likely;
      best = curve;
    }
  }
  return best;
}

double risk(const LossCurve& curve, const Prediction& prediction) {
  const double deviation_db = std::max(prediction.deviation_db, 0.1);
  return 0.5 * std::erfc((prediction.mean_dbm - curve.half_dbm) / (deviation_db * std::sqrt(2.0)));
}

}  // namespace tocsin::link_map
