// SPDX-License-Identifier: Apache-2.0
#include "fit_start.hpp"

#include <algorithm>

namespace tocsin::decision {
namespace {

template <class Function>
double mean_of(const std::vector<double>& values, Function f) {
  double sum = 0;
  for (const double x : values) sum += f(x);
  return sum / static_cast<double>(values.size());
}

template <class Function>
double deviation_of(const std::vector<double>& values, double mean, Function f) {
  return std::sqrt(mean_of(values, [&](double x) { return (f(x) - mean) * (f(x) - mean); }));
}

double middle(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

double log_of(double x) { return std::log(x); }
double square_of(double x) { return x * x; }
double identity(double x) { return x; }

/// Beta by moments, on [0,100].
Density::Parameters beta_start(const Moments& m) {
  const double u = m.mean / 100;
  const double v = m.sd * m.sd / 1e4;
  const double size = std::max(u * (1 - u) / v - 1, 0.1);
  return {u * size, (1 - u) * size, 0};
}

Density::Parameters positive_start(Family family, const Moments& m) {
  const double ratio = m.mean * m.mean / (m.sd * m.sd);
  switch (family) {
    case Family::weibull:
      return {m.mean, 1.2 / std::max(m.log_sd, 1e-6), 0};
    case Family::gamma:
      return {ratio, m.mean / ratio, 0};
    case Family::lognormal:
      return {m.log_mean, m.log_sd, 0};
    case Family::loglogistic:
      return {m.log_mean, m.log_sd * std::sqrt(3) / M_PI, 0};
    case Family::inverse_gaussian:
      return {m.mean, 1 / m.reciprocal_excess, 0};
    case Family::rayleigh:
      return {std::sqrt(m.square / 2), 0, 0};
    case Family::rician:
      return {std::max(m.mean, 1e-3), m.sd, 0};
    case Family::nakagami:
      return {m.square * m.square / (m.square_sd * m.square_sd), m.square, 0};
    case Family::exponential:
      return {m.mean, 0, 0};
    case Family::birnbaum_saunders:
      return {std::sqrt(m.mean / m.reciprocal), m.log_sd, 0};
    default:
      return beta_start(m);
  }
}

}  // namespace

Moments::Moments(const std::vector<double>& sorted)
    : n(static_cast<double>(sorted.size())),
      mean(mean_of(sorted, identity)),
      sd(deviation_of(sorted, mean, identity)),
      log_mean(mean_of(sorted, log_of)),
      log_sd(deviation_of(sorted, log_mean, log_of)),
      square(mean_of(sorted, square_of)),
      square_sd(deviation_of(sorted, square, square_of)),
      reciprocal(mean_of(sorted, [](double x) { return 1 / x; })),
      reciprocal_excess(mean_of(
          sorted, [this](double x) { return (x - mean) * (x - mean) / (x * mean * mean); })),
      median(middle(sorted)),
      deviation(mean_of(sorted, [this](double x) { return std::abs(x - median); })) {}

Density::Parameters starting_point(Family family, const Moments& m) {
  const double gumbel = m.sd * std::sqrt(6) / M_PI;
  constexpr double euler = 0.57721566490153286;
  switch (family) {
    case Family::normal:
    case Family::truncated_normal:
      return {m.mean, m.sd, 0};
    case Family::logistic:
      return {m.mean, m.sd * std::sqrt(3) / M_PI, 0};
    case Family::t_location_scale:
      return {m.mean, m.sd, 8};
    case Family::laplace:
      return {m.median, m.deviation, 0};
    case Family::gumbel_max:
      return {m.mean - euler * gumbel, gumbel, 0};
    case Family::gumbel_min:
      return {m.mean + euler * gumbel, gumbel, 0};
    case Family::gev:
      return {-0.2, m.sd, m.mean - 0.4 * m.sd};
    default:
      return positive_start(family, m);
  }
}

bool has_closed_form(Family family) {
  switch (family) {
    case Family::normal:
    case Family::laplace:
    case Family::lognormal:
    case Family::inverse_gaussian:
    case Family::rayleigh:
    case Family::exponential:
      return true;
    default:
      return false;
  }
}

}  // namespace tocsin::decision
