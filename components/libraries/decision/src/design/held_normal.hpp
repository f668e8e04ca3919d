// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "decision/cusum.hpp"

namespace tocsin::decision {

/// A normal law whose values are held within [0,100]: what is beyond counts at the end.
struct HeldNormal {
  double mean;
  double variance;

  /// Density within, probability at an end; its logarithm.
  [[nodiscard]] double log_density(double x) const;
  /// P(X < x) and P(X <= x), which differ at the ends.
  [[nodiscard]] double below(double x) const;
  [[nodiscard]] double up_to(double x) const;
};

/// Mean and variance of what was meant by `x`: itself, or what lies beyond the end it is held at.
HeldNormal meant_by(double x, const Normal& law);

inline bool is_held(double x) { return x <= 0 || x >= 100; }

}  // namespace tocsin::decision
