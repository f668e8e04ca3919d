// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "decision/density.hpp"

namespace tocsin::decision {

/// Sums that estimates start from; `sorted` is ascending and positive.
struct Moments {
  explicit Moments(const std::vector<double>& sorted);
  double n;
  double mean;
  double sd;                 ///< root of the mean squared deviation
  double log_mean;           ///< of ln x
  double log_sd;             ///< of ln x
  double square;             ///< mean of x^2
  double square_sd;          ///< of x^2
  double reciprocal;         ///< mean of 1/x
  double reciprocal_excess;  ///< mean of 1/x above 1/mean, as the sum of squares that it is
  double median;
  double deviation;  ///< mean |x - median|
};

/// Estimates by moments or quantiles; for the families of has_closed_form the maximum itself.
[[nodiscard]] Density::Parameters starting_point(Family family, const Moments& m);

/// Whether starting_point already maximises the likelihood: normal, laplace, lognormal,
/// inverse_gaussian, rayleigh, exponential.
[[nodiscard]] bool has_closed_form(Family family);

}  // namespace tocsin::decision
