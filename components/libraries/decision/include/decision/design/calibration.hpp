// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "decision/design/link_model.hpp"
#include "decision/detectors.hpp"

namespace tocsin::decision {

/// What a threshold is calibrated for.
struct CalibrationRequest {
  std::vector<double> qualities;  ///< of a good link, at equal steps; NaN is a gap
  std::shared_ptr<Detector> detector;
  double samples;        ///< wanted mean samples between false alarms
  int block = 0;         ///< [samples] of resampled blocks; 0: as long as correlation lasts
  int replicates = 100;  ///< recordings that are simulated for the interval
  int paths = 3200;      ///< simulated for the threshold, each two wanted run lengths long
  std::uint64_t seed = 1;
};

/// Mean samples between false alarms that a threshold may have in truth.
struct Interval {
  double low;
  double high;
};

/// A threshold calibrated on a recording, and what it is worth.
struct Calibration {
  double threshold;
  Interval true_samples;  ///< 95 % interval of the mean samples between false alarms
  double needed_samples;  ///< length of a recording that would give +-20 %
  double held_samples;    ///< qualities in this one
  int alarms_seen;        ///< by the detector at the threshold, in the recording itself
  LinkFit fit;            ///< the model of the link that was simulated
  /// True when even the smallest threshold has fewer false alarms than wanted: the recording holds
  /// too little that looks bad. threshold is then that smallest one, true_samples what it has.
  bool any_threshold;
  /// The recording is shorter than ten of the wanted times, so that the threshold rests on the
  /// model's tail rather than on false alarms that were seen.
  [[nodiscard]] bool extrapolated() const { return held_samples < 10 * wanted_samples; }
  double wanted_samples;
};

/// Fits models of the link to the recording, takes the one whose forecasts hold (fit_link), and
/// finds the threshold by simulating it at length. The interval is a bootstrap of the whole
/// procedure: recordings as long as this one are drawn from the model, a model is fitted to each
/// and a threshold taken from that, and the true run length of each threshold is read off the model
/// they were drawn from. So it holds the recording's length and correlation; it does not hold that
/// tomorrow's link is another one. Blocks for some seconds. Deterministic for a seed.
/// Throws ConfigError when the recording is too short to fit (fit_ar1).
[[nodiscard]] Calibration calibrate(const CalibrationRequest& request);

}  // namespace tocsin::decision
