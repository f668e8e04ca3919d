// SPDX-License-Identifier: Apache-2.0
#include "decision/law_learner.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

constexpr double k = 1.5;               // Huber's; of |z| beyond it, 0.134 of a normal law
constexpr double within = 0.8664;       // P(|z| < k)
constexpr double mean_square = 0.7785;  // E min(z^2, k^2)
constexpr double slope = 0.9557;        // its derivative by ln sd
constexpr double least_samples = 10;    // effective ones, before which nothing is said

}  // namespace

LawLearner::LawLearner(Normal start, const LearnerLimits& limits)
    : start_(start), limits_(limits), law_(start) {
  const bool sound = start.sd > 0 && limits.memory_samples > 0 && limits.max_shift_sd > 0 &&
                     limits.max_spread >= 1;
  if (sound) return;
  std::ostringstream text;
  text << "law learner: sd " << start.sd << ", memory_samples " << limits.memory_samples
       << " and max_shift_sd " << limits.max_shift_sd << " must be above 0, max_spread "
       << limits.max_spread << " at least 1";
  throw ConfigError(text.str());
}

void LawLearner::add(double qni) {
  if (std::isnan(qni)) return;
  const double z = std::clamp((qni - law_.mean) / law_.sd, -k, k);
  samples_ = std::min(samples_ + 1, limits_.memory_samples);
  const double gain = 1 / limits_.memory_samples;
  const double shift = limits_.max_shift_sd * start_.sd;
  law_.mean =
      std::clamp(law_.mean + gain * law_.sd * z / within, start_.mean - shift, start_.mean + shift);
  law_.sd = std::clamp(law_.sd * std::exp(gain * (z * z - mean_square) / slope),
                       start_.sd / limits_.max_spread, start_.sd * limits_.max_spread);
  product_ += (z * before_ / mean_square - product_) / std::min(samples_, 300.0);
  before_ = z;
}

double LawLearner::effective_samples() const {
  const double correlation = std::clamp(product_, 0.0, 0.999);
  return 2 * samples_ * (1 - correlation) /
         (1 + correlation);  // an exponential memory of m holds 2 m
}

double LawLearner::evidence() const {
  const double n = effective_samples();
  if (n < least_samples) return 0;
  constexpr double efficiency = 0.964;  // of the estimate at a normal law
  return (law_.mean - start_.mean) / law_.sd * std::sqrt(efficiency * n);
}

double LawLearner::spread_evidence() const {
  const double n = effective_samples();
  if (n < least_samples) return 0;
  constexpr double variance = 0.689;  // of ln sd times n: Var min(z^2, k^2) / slope^2
  return std::log(law_.sd / start_.sd) * std::sqrt(n / variance);
}

}  // namespace tocsin::decision
