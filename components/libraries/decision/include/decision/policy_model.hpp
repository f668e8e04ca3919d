// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "decision/llr.hpp"
#include "decision/policy_params.hpp"
#include "decision/run_length.hpp"

namespace tocsin::decision {

/// The laws that the parameters name. Each throws ConfigError for a law that is none.
[[nodiscard]] Density good_law_of(const PolicyParams& params);
[[nodiscard]] Density bad_law_of(const PolicyParams& params);

/// The clipped log-likelihood ratio of both laws.
[[nodiscard]] Llr llr_of(const PolicyParams& params);

/// The steps of the CUSUM for "turned bad" and of the reverse one, when QNI follows `truth`. Exact
/// when all laws are normal, else on a grid.
[[nodiscard]] StepLaw step_law_of(const PolicyParams& params, const Density& truth);
[[nodiscard]] StepLaw reverse_step_law_of(const PolicyParams& params, const Density& truth);

/// The run length that is wanted, or that alpha has for the CUSUM.
[[nodiscard]] double false_alarm_samples_of(const PolicyParams& params);

/// The thresholds, as given or from the wanted run lengths.
[[nodiscard]] double alpha_of(const PolicyParams& params);
[[nodiscard]] double reverse_alpha_of(const PolicyParams& params);

}  // namespace tocsin::decision
