// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "metrics/messages.hpp"
#include "plan/experiment_file.hpp"

namespace tocsin::experiment {

/// Later than this is late: half of the 0.5 s after which velocity_mux lets a silent source go.
inline constexpr double late_s = 0.25;
/// Later than this is very late: the vehicle has stopped for want of a velocity, and a person at
/// the station has noticed that nothing moves.
inline constexpr double very_late_s = 1;

/// Share [%] of the messages that came later than `limit_s` or never; NaN without messages.
[[nodiscard]] double late_percent(const std::vector<Message>& messages, double limit_s);

/// What users feel of a run; NaN where it has no answer.
struct UserFigures {
  double critical_late;       ///< [%] later than late_s or lost, class critical of the vehicle
  double critical_very_late;  ///< [%] later than very_late_s or lost
  double high_late;           ///< [%]
  double high_very_late;      ///< [%]
  double low_delivered;       ///< [%] of what was written in class low
  double location_age_p99;    ///< [s]
  double picture_p99;         ///< [ms]
  double airtime;             ///< [%]
};

/// The sum of all figures by their weights: 0 is a link that nobody notices. What a run has no
/// answer to (no camera) costs nothing; NaN when nothing is known of class critical.
[[nodiscard]] double user_cost(const UserFigures& figures, const CostWeights& weights);

}  // namespace tocsin::experiment
