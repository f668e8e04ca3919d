// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "decision/policy_params.hpp"
#include "metrics/metrics.hpp"
#include "plan/fitted_file.hpp"

namespace tocsin::experiment {

/// What the runs of one mission without a policy measured, slot by slot.
struct Trace {
  std::vector<double> qni;  ///< NaN: no sample in this slot
  std::vector<bool> bad;
};
[[nodiscard]] Trace trace_of(const std::vector<Observation>& series);

/// The best setting of a policy.
struct Tuned {
  std::string policy;
  std::vector<std::string> settings;  ///< "key=value" of the two numbers that were tuned
  double regret;  ///< cost over the clairvoyant's per 1000 slots, mean over the traces
};

/// All that is fitted to one mission.
struct MissionFit {
  std::vector<std::string> laws;  ///< settings that all policies share
  std::vector<Tuned> policies;
};

/// The laws of QNI in good and in bad slots, as normals by maximum likelihood, and the mean lengths
/// of both states. Throws ConfigError, naming `mission`, when there are too few of either.
[[nodiscard]] decision::PolicyParams fit_laws(const std::vector<Trace>& traces,
                                              const std::string& mission);

/// Fits laws, then tries for each policy all pairs of its two numbers on a grid: each trace is
/// decided again, and the pair with the least mean cost is taken, the first of equal ones. The same
/// rule, data and cost for every policy. Silence does not change a trace, as it would a link.
[[nodiscard]] MissionFit fit_policies(const std::vector<Trace>& traces, const std::string& mission);

/// What the file of fitted parameters says of it.
[[nodiscard]] Fitted::mapped_type settings_of(const MissionFit& fit);

}  // namespace tocsin::experiment
