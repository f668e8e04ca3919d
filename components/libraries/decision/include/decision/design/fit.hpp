// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "decision/density.hpp"

namespace tocsin::decision {

/// A family fitted to data by maximum likelihood.
struct Fit {
  Density density;
  double log_likelihood;  ///< natural logarithm, summed over the data
  int parameter_count;
  double aic;
  double aicc;  ///< AIC with the correction for small samples
  double bic;
  double ks;  ///< Kolmogorov-Smirnov distance; a distance only, its p-value would be too large
  /// True when a parameter ran to its limit (a t law towards normal, say) or the search did not
  /// end: the likelihood is then that of the limit and the parameters mean little.
  bool at_boundary;
};

/// Quality data prepared for fitting: sorted and held in [0.5, 99.5], because quality reaches 0
/// and 100 exactly, where several families have no or infinite density.
struct FitData {
  std::vector<double> sorted;
  std::size_t held = 0;       ///< how many values were moved to the limits
  double lag1 = 0;            ///< autocorrelation of neighbours in time
  double effective_size = 0;  ///< n (1-lag1)/(1+lag1), at most n: what n is worth to BIC
};

/// Throws ConfigError, one line naming `name`, when there are fewer than 10 values, one is not
/// finite, or all are equal.
[[nodiscard]] FitData prepare_fit(const std::vector<double>& values, const char* name);

/// Fits one family.
[[nodiscard]] Fit fit(Family family, const FitData& data);

/// Fits all families; smallest BIC first, those at a boundary last.
[[nodiscard]] std::vector<Fit> fit_all(const FitData& data);

}  // namespace tocsin::decision
