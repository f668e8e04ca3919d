// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "decision/llr.hpp"

namespace tocsin::decision {

/// How one step of a CUSUM is distributed: above(y) = P(step > y), falling from 1 to 0. Give small
/// probabilities accurately (not as 1 minus a large one): long run lengths hang on them.
struct StepLaw {
  std::function<double(double)> above;
};

/// The log-likelihood ratio of a normal pair when QNI is normal with `truth`; exact.
[[nodiscard]] StepLaw step_law(const NormalLlr& llr, double clip, Normal truth);
/// The negative ratio, the step of the reverse CUSUM ("turned good").
[[nodiscard]] StepLaw reverse_step_law(const NormalLlr& llr, double clip, Normal truth);
/// Any ratio when QNI follows `truth` within [0,100]; on a grid of 10 000 cells.
[[nodiscard]] StepLaw step_law(const Llr& llr, const Density& truth);
[[nodiscard]] StepLaw reverse_step_law(const Llr& llr, const Density& truth);

/// Mean number of samples until W = max(0, W + step), started at 0, reaches `alpha` (> 0): the mean
/// time between false alarms when the law is that of a good network, the mean delay when it is
/// that of a bad one.
///
/// Markov chain of Brook and Evans (1972), solved by elimination without subtraction (Grassmann,
/// Taksar, Heyman), so that run lengths of 1e14 keep their digits; extrapolated from 200 and 400
/// states for laws without atoms (`smooth`), 400 states with atoms (clipped ratios; about 1 %).
[[nodiscard]] double mean_run_length(const StepLaw& law, double alpha, bool smooth = true);

/// The threshold whose mean run length under `law` is `samples`.
/// Throws ConfigError when `samples` is below the run length of the smallest threshold or beyond
/// what thresholds up to 1000 reach.
[[nodiscard]] double alpha_for_run_length(const StepLaw& law, double samples, bool smooth = true);

}  // namespace tocsin::decision
