// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "decision/design/costs.hpp"
#include "policy_settings.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {

/// One decision of a trace that is decided again.
struct Step {
  double time_s = 0;               ///< on the trace's clock
  std::optional<std::size_t> row;  ///< of the trace; empty: a pause ended between two rows
  decision::Evidence evidence;
};

/// A recorded trace decided again.
struct DecidedTrace {
  QualityTrace trace;
  std::string policy;
  std::vector<Step> steps;
  PolicySettings settings;
};

/// Feeds the trace to the policy that the settings name; "oracle" as `policy` is the clairvoyant,
/// which needs the truth. A pause also ends at its deadline between two rows. A controller that was
/// restarted in the recording begins anew. With the settings of the recorded run every decision is
/// the recorded one. Throws ConfigError.
[[nodiscard]] DecidedTrace decide_again(const QualityTrace& trace, const std::string& policy,
                                        const PolicySettings& settings);

/// What the decisions amount to.
struct DecisionSummary {
  std::size_t samples = 0;
  std::size_t missing = 0;
  std::size_t passive = 0;  ///< samples after which the state was passive
  std::size_t pauses = 0;
  std::size_t forced = 0;  ///< pauses that ended by a limit of silence
  int longest_pause = 0;   ///< [samples]
  double mean_qni_active = 0;
  double mean_qni_passive = 0;
  bool has_truth = false;  ///< the rest needs the truth
  /// Of slots 1 to the last, sample n deciding slot n + 1; one in which a pause ended at its
  /// deadline counts as spoken in.
  double cost = 0;
  double oracle_cost = 0;
};

[[nodiscard]] DecisionSummary summarize(const DecidedTrace& decided);

/// How the decisions compare with those that the recording holds.
struct Comparison {
  std::size_t recorded = 0;  ///< decisions in the recording
  std::size_t recorded_pauses = 0;
  std::size_t same = 0;                    ///< of equal state, reason and age of the pause
  std::optional<std::size_t> first_other;  ///< row of the first one that is not
};

/// Empty when the trace holds no decisions.
[[nodiscard]] std::optional<Comparison> compare_with_recording(const DecidedTrace& decided);

}  // namespace tocsin::tools
