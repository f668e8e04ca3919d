// SPDX-License-Identifier: Apache-2.0
#include "special_functions.hpp"

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace tocsin::decision {

double normal_quantile(double p) {
  constexpr double limit = 8;
  constexpr double least = 1e-15;
  if (p <= least) return -limit;
  if (p >= 1 - least) return limit;
  return std::clamp(-M_SQRT2 * boost::math::erfc_inv(2 * p), -limit, limit);
}

double log_normal_cdf(double z) {
  if (z > -35) return std::log(normal_cdf(z));
  return -z * z / 2 + std::log(scaled_normal_tail(-z));
}

double scaled_normal_tail(double z) {
  if (z < 35) return normal_cdf(-z) * std::exp(z * z / 2);
  const double i = 1 / (z * z);  // Abramowitz & Stegun 26.2.12
  return (1 - i + 3 * i * i) / (z * std::sqrt(2 * M_PI));
}

double log_gamma_half_step(double x) { return -std::log(boost::math::tgamma_delta_ratio(x, 0.5)); }

double log_bessel_i0_scaled(double z) {
  if (z < 600) return std::log(boost::math::cyl_bessel_i(0, z)) - z;
  const double i = 1 / (8 * z);  // Abramowitz & Stegun 9.7.1
  return -std::log(2 * M_PI * z) / 2 + std::log1p(i * (1 + 4.5 * i * (1 + 25 * i / 3)));
}

}  // namespace tocsin::decision
