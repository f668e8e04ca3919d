// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "decision/cusum.hpp"
#include "decision/policy_params.hpp"

namespace tocsin::decision {

/// The parameters of a policy for another law of the good link, with the same mean times between
/// false alarms and between false resumes.
///
/// The bad law stays: it says what a user calls bad. The thresholds of both CUSUMs are computed
/// anew. A mild degradation and FOCuS are measured in spreads of the good law, so that theirs hold;
/// that of Shiryaev-Roberts moves as the CUSUM's.
class LawDesign {
 public:
  /// Throws ConfigError as make_policy. Takes some tenths of a second.
  explicit LawDesign(const PolicyParams& params);
  /// Empty when `good` does not lie above the bad law. Where no threshold has false alarms as often
  /// as configured, the configured one stays, which has fewer. Takes some milliseconds.
  [[nodiscard]] std::optional<PolicyParams> for_good(const Normal& good) const;

 private:
  PolicyParams params_;  // its thresholds are numbers, not times
  double alarm_samples_;
  double resume_samples_;
  double mild_depth_;  // in spreads
};

}  // namespace tocsin::decision
