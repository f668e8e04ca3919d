// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "decision/qni.hpp"

namespace tocsin::decision {

/// Weights and ranges of the second index.
struct ChannelQniParams {
  double weight_per = 0.4;
  double weight_signal = 0.3;
  double weight_channel = 0.3;
  double signal_worst_dbm = -99.0;
  double signal_best_dbm = -45.0;
  double retries_worst = 3.0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("weight_per", weight_per, {0, 1}, "[1] weight of 100 - packet error rate");
    v("weight_signal", weight_signal, {0, 1}, "[1] weight of the signal strength");
    v("weight_channel", weight_channel, {0, 1}, "[1] weight of free air time or few retries");
    v("signal_worst_dbm", signal_worst_dbm, {-120, 0}, "[dBm] this and weaker scores 0");
    v("signal_best_dbm", signal_best_dbm, {-120, 0}, "[dBm] this and stronger scores 100");
    v("retries_worst", retries_worst, {0.01, 100}, "[1] retries per frame that score 0");
  }
};

/// What nl80211 tells of the channel besides the signal; absent and NaN mean "not told".
struct ChannelQniInput {
  std::optional<double> per_percent;        ///< lost packets [0,100]; a dead link is 100
  std::optional<double> signal_dbm;         ///< received signal strength
  std::optional<double> busy_share;         ///< busy time over active time of the survey, [0,1]
  std::optional<double> retries_per_frame;  ///< transmit retries over transmitted frames, >= 0
};

/// An index that counts the signal once: PER, signal, and how free the channel is - the worse of
/// idle air time and absence of retries, whichever of them is known.
///
/// On Linux the link quality of most drivers is signal + 110 on a scale of 70, so QniModel gives
/// the signal a weight of 0.6. Use QniModel to compare with the thesis, or where only
/// /proc/net/wireless or iwconfig is to be had. Use this one where nl80211 gives survey or station
/// counters: it sees congestion, which lowers neither signal nor link quality. The laws of the
/// policies belong to one model: fit them again after a change of model.
class ChannelQniModel {
 public:
  /// Throws ConfigError when the weights do not sum to 1 or the signal range is empty.
  explicit ChannelQniModel(const ChannelQniParams& params);
  /// `has_quality` and its weight stand for the channel term here.
  [[nodiscard]] Qni evaluate(const ChannelQniInput& input) const;

 private:
  ChannelQniParams params_;
};

}  // namespace tocsin::decision
