// SPDX-License-Identifier: Apache-2.0
#include "held_normal.hpp"

#include <algorithm>

#include "special_functions.hpp"

namespace tocsin::decision {

double HeldNormal::log_density(double x) const {
  const double sd = std::sqrt(variance);
  if (x >= 100) return log_normal_cdf((mean - 100) / sd);
  if (x <= 0) return log_normal_cdf(-mean / sd);
  return -0.5 * ((x - mean) * (x - mean) / variance + std::log(2 * M_PI * variance));
}

double HeldNormal::below(double x) const {
  return x <= 0 ? 0 : normal_cdf((std::min(x, 100.0) - mean) / std::sqrt(variance));
}

double HeldNormal::up_to(double x) const {
  return x >= 100 ? 1 : normal_cdf((std::max(x, 0.0) - mean) / std::sqrt(variance));
}

HeldNormal meant_by(double x, const Normal& law) {
  if (!is_held(x)) return {x, 0};
  const double side = x >= 100 ? 1 : -1;
  const double z = side * ((x >= 100 ? 100 : 0) - law.mean) / law.sd;
  const double hazard = std::exp(-z * z / 2 - log_normal_cdf(-z)) / std::sqrt(2 * M_PI);
  const double variance = std::max(0.0, 1 + z * hazard - hazard * hazard);
  return {law.mean + side * law.sd * hazard, law.sd * law.sd * variance};
}

}  // namespace tocsin::decision
