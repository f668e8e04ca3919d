// SPDX-License-Identifier: Apache-2.0
#include "decision/density.hpp"

#include <cmath>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

const double ln_2pi = std::log(2 * M_PI);

struct Shape {
  const char* name;
  std::vector<const char*> parameters;
  unsigned any_sign;  // bit i: parameter i may be zero or negative
};

const Shape& shape(Family family) {
  static const std::array<Shape, family_count> shapes{{
      {"normal", {"mu", "sigma"}, 1},
      {"logistic", {"mu", "s"}, 1},
      {"t_location_scale", {"mu", "sigma", "nu"}, 1},
      {"laplace", {"mu", "b"}, 1},
      {"gumbel_max", {"mu", "beta"}, 1},
      {"gumbel_min", {"mu", "beta"}, 1},
      {"gev", {"k", "sigma", "mu"}, 5},
      {"weibull", {"scale", "shape"}, 0},
      {"gamma", {"shape", "scale"}, 0},
      {"lognormal", {"mu", "sigma"}, 1},
      {"loglogistic", {"mu", "sigma"}, 1},
      {"inverse_gaussian", {"mu", "lambda"}, 0},
      {"rayleigh", {"b"}, 0},
      {"rician", {"s", "sigma"}, 0},
      {"nakagami", {"m", "omega"}, 0},
      {"exponential", {"mu"}, 0},
      {"birnbaum_saunders", {"beta", "gamma"}, 0},
      {"beta", {"a", "b"}, 0},
      {"truncated_normal", {"mu", "sigma"}, 1},
  }};
  return shapes[static_cast<std::size_t>(family)];
}

void check(Family family, const Density::Parameters& p) {
  const Shape& s = shape(family);
  for (std::size_t i = 0; i < s.parameters.size(); ++i) {
    const bool any_sign = (s.any_sign >> i & 1U) != 0;
    if (std::isfinite(p[i]) && (any_sign || p[i] > 0)) continue;
    std::ostringstream text;
    text << "density " << s.name << '.' << s.parameters[i] << ": " << p[i] << " must be "
         << (any_sign ? "finite" : "finite and above 0");
    throw ConfigError(text.str());
  }
}

double truncated_mass(double mu, double sigma) {
  return normal_interval(-mu / sigma, (100 - mu) / sigma);
}

/// The part of ln f that is free of x, so that a sample costs little.
double constant(Family family, const Density::Parameters& p) {
  switch (family) {
    case Family::normal:
      return -std::log(p[1]) - ln_2pi / 2;
    case Family::logistic:
    case Family::gumbel_max:
    case Family::gumbel_min:
    case Family::gev:
      return -std::log(p[1]);
    case Family::t_location_scale:
      return log_gamma_half_step(p[2] / 2) - std::log(p[2] * M_PI) / 2 - std::log(p[1]);
    case Family::laplace:
      return -std::log(2 * p[1]);
    case Family::weibull:
      return std::log(p[1]) - p[1] * std::log(p[0]);
    case Family::gamma:
      return -std::lgamma(p[0]) - p[0] * std::log(p[1]);
    case Family::lognormal:
      return -std::log(p[1]) - ln_2pi / 2;
    case Family::loglogistic:
      return -std::log(p[1]);
    case Family::inverse_gaussian:
      return (std::log(p[1]) - ln_2pi) / 2;
    case Family::rayleigh:
      return -2 * std::log(p[0]);
    case Family::rician:
      return -2 * std::log(p[1]);
    case Family::nakagami:
      return std::log(2) + p[0] * std::log(p[0] / p[1]) - std::lgamma(p[0]);
    case Family::exponential:
      return -std::log(p[0]);
    case Family::birnbaum_saunders:
      return -std::log(2 * p[1]) - ln_2pi / 2;
    case Family::beta:
      return std::lgamma(p[0] + p[1]) - std::lgamma(p[0]) - std::lgamma(p[1]) - std::log(100);
    case Family::truncated_normal:
      return -std::log(p[1]) - ln_2pi / 2 - std::log(truncated_mass(p[0], p[1]));
  }
  return 0;
}

/// ln of the standard logistic density.
double log_logistic(double z) {
  const double a = std::abs(z);
  return -a - 2 * std::log1p(std::exp(-a));
}

/// ln of the standard GEV density; near k = 0 it is the Gumbel law.
double log_gev(double k, double z) {
  if (std::abs(k) < 1e-9) return -z - std::exp(-z);
  const double t = 1 + k * z;
  if (t <= 0) return -infinity;
  const double y = std::log(t) / k;
  return -(1 + k) * y - std::exp(-y);
}

double log_birnbaum_saunders(double x, double beta, double gamma) {
  const double root = std::sqrt(x / beta);
  const double z = (root - 1 / root) / gamma;
  return std::log((root + 1 / root) / x) - z * z / 2;
}

}  // namespace

const std::array<Family, family_count>& all_families() {
  static const auto families = [] {
    std::array<Family, family_count> all{};
    for (int i = 0; i < family_count; ++i) all[static_cast<std::size_t>(i)] = Family{i};
    return all;
  }();
  return families;
}

const char* to_string(Family family) { return shape(family).name; }

std::optional<Family> family_from(const std::string& name) {
  for (const Family family : all_families()) {
    if (name == to_string(family)) return family;
  }
  return std::nullopt;
}

std::vector<const char*> parameter_names(Family family) { return shape(family).parameters; }

Density::Density(Family family, const Parameters& parameters)
    : family_(family), p_(parameters), constant_(0) {
  check(family, parameters);
  for (std::size_t i = shape(family).parameters.size(); i < p_.size(); ++i) p_[i] = 0;
  constant_ = constant(family, p_);
}

double Density::log_density(double x) const {
  switch (family_) {
    case Family::normal:
    case Family::logistic:
    case Family::t_location_scale:
    case Family::laplace:
    case Family::gumbel_max:
    case Family::gumbel_min:
    case Family::gev:
      return constant_ + real_line_log_density(x);
    case Family::beta:
    case Family::truncated_normal:
      return constant_ + bounded_log_density(x);
    default:
      return x <= 0 ? -infinity : constant_ + positive_log_density(x);
  }
}

double Density::real_line_log_density(double x) const {
  const double z = (x - p_[0]) / p_[1];
  switch (family_) {
    case Family::normal:
      return -z * z / 2;
    case Family::logistic:
      return log_logistic(z);
    case Family::t_location_scale:
      return -(p_[2] + 1) / 2 * std::log1p(z * z / p_[2]);
    case Family::laplace:
      return -std::abs(z);
    case Family::gumbel_max:
      return -z - std::exp(-z);
    case Family::gumbel_min:
      return z - std::exp(z);
    default:
      return log_gev(p_[0], (x - p_[2]) / p_[1]);
  }
}

double Density::positive_log_density(double x) const {
  const double ln = std::log(x);
  const double z = (ln - p_[0]) / p_[1];
  switch (family_) {
    case Family::weibull:
      return (p_[1] - 1) * ln - std::pow(x / p_[0], p_[1]);
    case Family::gamma:
      return (p_[0] - 1) * ln - x / p_[1];
    case Family::lognormal:
      return -ln - z * z / 2;
    case Family::loglogistic:
      return -ln + log_logistic(z);
    case Family::inverse_gaussian:
      return -1.5 * ln - p_[1] * (x - p_[0]) * (x - p_[0]) / (2 * p_[0] * p_[0] * x);
    case Family::rayleigh:
      return ln - x * x / (2 * p_[0] * p_[0]);
    case Family::rician: {
      // exp(-(x-s)^2/2 sigma^2) with the scaled Bessel function: neither over- nor underflows
      const double gap = (x - p_[0]) / p_[1];
      return ln - gap * gap / 2 + log_bessel_i0_scaled(x * p_[0] / (p_[1] * p_[1]));
    }
    case Family::nakagami:
      return (2 * p_[0] - 1) * ln - p_[0] * x * x / p_[1];
    case Family::exponential:
      return -x / p_[0];
    default:
      return log_birnbaum_saunders(x, p_[0], p_[1]);
  }
}

double Density::bounded_log_density(double x) const {
  if (x < 0 || x > 100) return -infinity;
  if (family_ == Family::truncated_normal) {
    const double z = (x - p_[0]) / p_[1];
    return -z * z / 2;
  }
  const double u = x / 100;
  // 0 * ln 0 is 0 here: with a = 1 the density at 0 is finite
  const double left = p_[0] == 1 ? 0 : (p_[0] - 1) * std::log(u);
  const double right = p_[1] == 1 ? 0 : (p_[1] - 1) * std::log1p(-u);
  return left + right;
}

}  // namespace tocsin::decision
