// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "report/recording.hpp"
#include "report/summary.hpp"

namespace tocsin::experiment {

/// What counts as truly poor.
struct PoorLink {
  double below_db;    ///< mean SNR
  double shortest_s;  ///< shorter intervals are not counted, shorter gaps do not divide one
};
[[nodiscard]] std::vector<report::Interval> truly_poor(const std::vector<report::LinkState>& link,
                                                       const PoorLink& poor, double begin_s,
                                                       double end_s);

/// How a policy did beside the clairvoyant, who pauses exactly while the link is truly poor.
struct AgainstTruth {
  int intervals = 0;        ///< truly poor ones
  int missed = 0;           ///< of these, without any pause
  double detect_s = 0;      ///< from the begin to the pause, mean over those found; NaN: none
  double resume_s = 0;      ///< from the end to speaking again, mean; NaN: no interval ended
  double sent_in_poor = 0;  ///< [%] of the poor time in which the gate was open; NaN: no poor time
  double silent_in_good = 0;  ///< [%] of the good time in which it was closed
};
[[nodiscard]] AgainstTruth compare(const std::vector<report::Interval>& poor,
                                   const std::vector<report::Interval>& pauses, double begin_s,
                                   double end_s);

/// Length that two lists of intervals have in common.
[[nodiscard]] double common_s(const std::vector<report::Interval>& a,
                              const std::vector<report::Interval>& b);
/// Total length.
[[nodiscard]] double length_s(const std::vector<report::Interval>& intervals);

}  // namespace tocsin::experiment
