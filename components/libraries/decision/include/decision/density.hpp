// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tocsin::decision {

/// The families of laws that a quality index is fitted with. Parameters in the order of
/// `parameter_names`. Beta and truncated normal live on [0,100].
enum class Family {
  normal,             ///< mu, sigma
  logistic,           ///< mu, s
  t_location_scale,   ///< mu, sigma, nu
  laplace,            ///< mu, b
  gumbel_max,         ///< mu, beta
  gumbel_min,         ///< mu, beta
  gev,                ///< k (Coles's xi), sigma, mu
  weibull,            ///< scale, shape
  gamma,              ///< shape, scale
  lognormal,          ///< mu, sigma of ln x
  loglogistic,        ///< mu, sigma of ln x
  inverse_gaussian,   ///< mu, lambda
  rayleigh,           ///< b
  rician,             ///< s, sigma
  nakagami,           ///< m, omega
  exponential,        ///< mu
  birnbaum_saunders,  ///< beta, gamma
  beta,               ///< a, b
  truncated_normal,   ///< mu, sigma
};

inline constexpr int family_count = 19;

/// Each family once, in the order of the enumeration.
[[nodiscard]] const std::array<Family, family_count>& all_families();
/// The enumerator as a word, for files and tables.
[[nodiscard]] const char* to_string(Family family);
/// The family of that name; empty when there is none.
[[nodiscard]] std::optional<Family> family_from(const std::string& name);
/// Names of the parameters, in their order.
[[nodiscard]] std::vector<const char*> parameter_names(Family family);

/// A law with its parameters. Log-densities are computed without forming the density, so tails do
/// not underflow. Evaluation neither allocates nor throws.
class Density {
 public:
  using Parameters = std::array<double, 3>;

  /// Parameters that the family does not have are ignored.
  /// Throws ConfigError when a parameter is not finite or a scale or shape is not above 0.
  Density(Family family, const Parameters& parameters);

  /// ln f(x); -infinity where the density is 0, NaN for NaN.
  [[nodiscard]] double log_density(double x) const;
  /// P(X <= x).
  [[nodiscard]] double cdf(double x) const;
  [[nodiscard]] Family family() const { return family_; }
  /// As many as parameter_names(family()); the rest is 0.
  [[nodiscard]] const Parameters& parameters() const { return p_; }

 private:
  double real_line_log_density(double x) const;
  double positive_log_density(double x) const;
  double bounded_log_density(double x) const;

  Family family_;
  Parameters p_;
  double constant_;  // the part of ln f that does not depend on x
};

}  // namespace tocsin::decision
