// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace tocsin::decision {

/// P(Z <= z) of the standard normal law, accurate in the lower tail.
inline double normal_cdf(double z) { return std::erfc(-z * M_SQRT1_2) / 2; }

/// P(a < Z <= b), accurate in both tails.
inline double normal_interval(double a, double b) {
  return a > 0 ? normal_cdf(-a) - normal_cdf(-b) : normal_cdf(b) - normal_cdf(a);
}

/// The standard normal density.
inline double normal_density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * M_PI); }

/// z with P(Z <= z) = p, held within +-8.
double normal_quantile(double p);
/// ln P(Z <= z), without underflow.
double log_normal_cdf(double z);
/// exp(z^2 / 2) P(Z > z) for z >= 0, without underflow.
double scaled_normal_tail(double z);
/// ln(Gamma(x + 1/2) / Gamma(x)), without the cancellation of two large logarithms.
double log_gamma_half_step(double x);
/// ln(exp(-z) I_0(z)) for z >= 0.
double log_bessel_i0_scaled(double z);

}  // namespace tocsin::decision
