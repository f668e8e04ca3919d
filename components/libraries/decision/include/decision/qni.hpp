// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tocsin::decision {

/// Weights and ranges of the quality index. The defaults are the thesis's, with weights that sum
/// to 1 (its source had 0.4 + 0.3 + 0.4) and its scales: signal -99 to -45 dBm, quality x/70.
struct QniParams {
  double weight_per = 0.4;
  double weight_signal = 0.3;
  double weight_quality = 0.3;
  double signal_worst_dbm = -99.0;
  double signal_best_dbm = -45.0;
  double quality_best = 70.0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("weight_per", weight_per, {0, 1}, "[1] weight of 100 - packet error rate");
    v("weight_signal", weight_signal, {0, 1}, "[1] weight of the signal strength");
    v("weight_quality", weight_quality, {0, 1}, "[1] weight of the link quality");
    v("signal_worst_dbm", signal_worst_dbm, {-120, 0}, "[dBm] this and weaker scores 0");
    v("signal_best_dbm", signal_best_dbm, {-120, 0}, "[dBm] this and stronger scores 100");
    v("quality_best", quality_best, {1, 255}, "[1] link quality that scores 100");
  }
};

/// What was measured in one sample. Absent and NaN both mean that the hardware did not tell.
struct QniInput {
  std::optional<double> per_percent;  ///< lost packets [0,100]; a dead link is 100, not absent
  std::optional<double> signal_dbm;   ///< received signal strength
  std::optional<double> quality;      ///< driver's link quality, 0 to `quality_best`
};

/// The readings of a NetworkQuality message, whose link quality is in percent of the 70 of
/// /proc/net/wireless. NaN: not told.
[[nodiscard]] inline QniInput qni_input(double per_percent, double signal_dbm,
                                        double quality_percent) {
  return {per_percent, signal_dbm, quality_percent / 100 * 70};
}

/// A quality index and what it rests on.
struct Qni {
  double value;         ///< [0,100], 100 is perfect; NaN when no term was measured
  bool has_per;         ///< whether the packet error rate took part
  bool has_signal;      ///< whether the signal strength took part
  bool has_quality;     ///< whether the link quality took part
  double weight_share;  ///< weight of the terms present before rescaling, in [0,1]

  /// True when terms of positive weight were missing and the other weights were rescaled.
  [[nodiscard]] bool rescaled() const { return weight_share < 1 - 1e-9; }
};

/// The network quality indicator, equation (24) of the thesis as corrected:
/// QNI = w_per (100 - PER) + w_signal S^ + w_quality Q^ with every term clipped to [0,100].
/// A missing term is left out and the remaining weights are scaled up to sum to 1.
///
/// On Linux the link quality of most drivers is signal + 110 on a scale of 70, so the thesis's
/// weights count the signal twice.
class QniModel {
 public:
  /// Throws ConfigError when the weights do not sum to 1 or the signal range is empty.
  explicit QniModel(const QniParams& params);
  [[nodiscard]] Qni evaluate(const QniInput& input) const;

 private:
  QniParams params_;
};

}  // namespace tocsin::decision
