// SPDX-License-Identifier: Apache-2.0
#include "metrics/user_cost.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::experiment {
namespace {

/// 0 for what has no answer.
double term(double weight, double value) { return std::isnan(value) ? 0 : weight * value; }

}  // namespace

double late_percent(const std::vector<Message>& messages, double limit_s) {
  if (messages.empty()) return std::nan("");
  const auto late = std::count_if(messages.begin(), messages.end(), [&](const Message& message) {
    return message.lost() || message.latency_s > limit_s;
  });
  return 100.0 * static_cast<double>(late) / static_cast<double>(messages.size());
}

double user_cost(const UserFigures& figures, const CostWeights& weights) {
  if (std::isnan(figures.critical_late)) return std::nan("");
  return term(weights.critical_late, figures.critical_late) +
         term(weights.critical_very_late, figures.critical_very_late) +
         term(weights.high_late, figures.high_late) +
         term(weights.high_very_late, figures.high_very_late) +
         term(weights.low_undelivered, 100 - figures.low_delivered) +
         term(weights.location_age, figures.location_age_p99) +
         term(weights.picture_latency, figures.picture_p99 / 1000) +
         term(weights.airtime, figures.airtime);
}

}  // namespace tocsin::experiment
