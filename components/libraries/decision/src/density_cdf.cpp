// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "decision/density.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

using Parameters = Density::Parameters;

double logistic_cdf(double z) { return 1 / (1 + std::exp(-z)); }

double laplace_cdf(double z) { return z < 0 ? std::exp(z) / 2 : 1 - std::exp(-z) / 2; }

double gev_cdf(double k, double z) {
  if (std::abs(k) < 1e-9) return std::exp(-std::exp(-z));
  const double t = 1 + k * z;
  if (t <= 0) return k > 0 ? 0 : 1;
  return std::exp(-std::pow(t, -1 / k));
}

double real_line_cdf(Family family, const Parameters& p, double x) {
  const double z = (x - p[0]) / p[1];
  switch (family) {
    case Family::normal:
      return normal_cdf(z);
    case Family::logistic:
      return logistic_cdf(z);
    case Family::t_location_scale:
      return cdf(boost::math::students_t(p[2]), z);
    case Family::laplace:
      return laplace_cdf(z);
    case Family::gumbel_max:
      return std::exp(-std::exp(-z));
    case Family::gumbel_min:
      return -std::expm1(-std::exp(z));
    default:
      return gev_cdf(p[0], (x - p[2]) / p[1]);
  }
}

double inverse_gaussian_cdf(double mu, double lambda, double x) {
  // The textbook's exp(2 lambda / mu) P(Z <= -v), v = root (x / mu + 1), without large exponents.
  const double root = std::sqrt(lambda / x);
  const double u = root * (x / mu - 1);
  return normal_cdf(u) + std::exp(-u * u / 2) * scaled_normal_tail(root * (x / mu + 1));
}

double rician_cdf(double s, double sigma, double x) {
  // Normal to within (sigma / s)^2, where Boost counts more terms than an int holds.
  if (s / sigma > 1e4) return normal_cdf((x - s) / sigma - sigma / (2 * s));
  const double noncentrality = (s / sigma) * (s / sigma);
  const double y = (x / sigma) * (x / sigma);
  return cdf(boost::math::non_central_chi_squared(2, noncentrality), y);
}

double positive_cdf(Family family, const Parameters& p, double x) {
  const double z = (std::log(x) - p[0]) / p[1];
  switch (family) {
    case Family::weibull:
      return -std::expm1(-std::pow(x / p[0], p[1]));
    case Family::gamma:
      return boost::math::gamma_p(p[0], x / p[1]);
    case Family::lognormal:
      return normal_cdf(z);
    case Family::loglogistic:
      return logistic_cdf(z);
    case Family::inverse_gaussian:
      return inverse_gaussian_cdf(p[0], p[1], x);
    case Family::rayleigh:
      return -std::expm1(-x * x / (2 * p[0] * p[0]));
    case Family::rician:
      return rician_cdf(p[0], p[1], x);
    case Family::nakagami:
      return boost::math::gamma_p(p[0], p[0] * x * x / p[1]);
    case Family::exponential:
      return -std::expm1(-x / p[0]);
    default:
      return normal_cdf((std::sqrt(x / p[0]) - std::sqrt(p[0] / x)) / p[1]);
  }
}

double bounded_cdf(Family family, const Parameters& p, double x) {
  const double held = std::clamp(x, 0.0, 100.0);
  if (family == Family::beta) return boost::math::ibeta(p[0], p[1], held / 100);
  const double low = -p[0] / p[1];
  return normal_interval(low, (held - p[0]) / p[1]) / normal_interval(low, (100 - p[0]) / p[1]);
}

}  // namespace

double Density::cdf(double x) const {
  switch (family_) {
    case Family::normal:
    case Family::logistic:
    case Family::t_location_scale:
    case Family::laplace:
    case Family::gumbel_max:
    case Family::gumbel_min:
    case Family::gev:
      return real_line_cdf(family_, p_, x);
    case Family::beta:
    case Family::truncated_normal:
      return bounded_cdf(family_, p_, x);
    default:
      return x <= 0 ? 0 : positive_cdf(family_, p_, x);
  }
}

}  // namespace tocsin::decision
