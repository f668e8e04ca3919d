// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "decision/policy.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {

/// A recorded trace decided again.
struct DecidedTrace {
  QualityTrace trace;
  std::string policy;
  std::vector<decision::Evidence> evidence;  ///< one per row
  decision::PolicyParams params;
};

/// Feeds the trace to the policy that `params` name; "oracle" as `policy` is the clairvoyant, which
/// needs the truth. A pause also ends at its deadline between two rows. Throws ConfigError.
[[nodiscard]] DecidedTrace decide_again(const QualityTrace& trace, const std::string& policy,
                                        decision::PolicyParams params);

/// What the decisions amount to.
struct DecisionSummary {
  std::size_t samples = 0;
  std::size_t missing = 0;
  std::size_t passive = 0;  ///< rows after which the state was passive
  std::size_t pauses = 0;
  std::size_t forced = 0;  ///< pauses that ended by a limit of silence
  int longest_pause = 0;   ///< [samples]
  double mean_qni_active = 0;
  double mean_qni_passive = 0;
  bool has_truth = false;  ///< the rest needs the truth
  double cost = 0;         ///< of slots 1 to the last, row n deciding slot n + 1
  double oracle_cost = 0;
};

[[nodiscard]] DecisionSummary summarize(const DecidedTrace& decided);

}  // namespace tocsin::tools
