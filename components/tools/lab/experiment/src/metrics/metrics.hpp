// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "metrics/metric.hpp"
#include "plan/experiment_file.hpp"
#include "report/recording.hpp"

namespace tocsin::experiment {

/// One observation of a run: `observation_s` long.
struct Observation {
  double time_s;      ///< its begin, since the run's first sample
  double qni;         ///< of the last decision in it; NaN: none
  double probe_per;   ///< [%] of the last measurement in it; NaN: none
  double snr_db;      ///< true mean SNR, mean over it; NaN: unknown
  double active;      ///< share of its time in which the gate was open
  double poor;        ///< share of its time in which the link was truly poor
  double sent;        ///< telemetry samples sent, those that were lost included
  double lost;        ///< of these, never arrived
  double latency_ms;  ///< median of the telemetry that was sent in it; NaN: none arrived
  bool stalled;       ///< the machine froze meanwhile (real runs)
};

/// A run in numbers.
struct Measures {
  std::vector<double> values;  ///< by index_of; NaN where the run has no answer
  std::vector<Observation> series;
};

/// An emulator that is later than this has been frozen with its machine.
inline constexpr double stall_ms = 50;

/// Measures a run, simulated or real alike. Pure.
[[nodiscard]] Measures measure(const report::Recording& recording, const Timing& timing);

}  // namespace tocsin::experiment
