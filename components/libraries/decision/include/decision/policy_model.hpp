// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "decision/detector.hpp"
#include "decision/llr.hpp"
#include "decision/policy_params.hpp"
#include "decision/run_length.hpp"

namespace tocsin::decision {

/// The laws that the parameters name. Each throws ConfigError for a law that is none.
[[nodiscard]] Density good_law_of(const PolicyParams& params);
[[nodiscard]] Density bad_law_of(const PolicyParams& params);

/// The clipped log-likelihood ratio of both laws, and of the good law against a mild degradation.
[[nodiscard]] Llr llr_of(const PolicyParams& params);
[[nodiscard]] Llr mild_llr_of(const PolicyParams& params);

/// The steps of the CUSUM for "turned bad" and of the reverse one, when QNI follows `truth`. Exact
/// when all laws are normal, else on a grid.
[[nodiscard]] StepLaw step_law_of(const PolicyParams& params, const Density& truth);
[[nodiscard]] StepLaw reverse_step_law_of(const PolicyParams& params, const Density& truth);

/// The run length that is wanted, or that alpha has for the CUSUM.
[[nodiscard]] double false_alarm_samples_of(const PolicyParams& params);

/// The thresholds, as given or from the wanted run lengths. With mild_share the first two have
/// together the run length that alpha or false_alarm_samples state (rates of false alarms add).
[[nodiscard]] double alpha_of(const PolicyParams& params);
/// 0: no second CUSUM.
[[nodiscard]] double mild_alpha_of(const PolicyParams& params);
[[nodiscard]] double reverse_alpha_of(const PolicyParams& params);

/// The detector of "turned bad" that the parameters name, with nothing heard yet.
[[nodiscard]] Detector detector_of(const PolicyParams& params);

/// At which statistic it alarms: alpha_of for the CUSUM; for others detector_threshold, else the
/// threshold with the run length that is wanted or that alpha has for the CUSUM, on independent
/// samples of the good law. That is simulated up to 2,000 samples, which takes a tenth of a second;
/// beyond, the run length of FOCuS is sqrt(h) exp(h) up to a constant (Siegmund and Venkatraman
/// 1995), and the threshold of Shiryaev-Roberts keeps its distance from the CUSUM's.
[[nodiscard]] double detector_threshold_of(const PolicyParams& params);

}  // namespace tocsin::decision
