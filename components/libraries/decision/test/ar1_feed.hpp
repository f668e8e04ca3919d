// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>

#include "decision/cusum.hpp"

namespace tocsin::decision {

/// Qualities of a normal law with correlated neighbours, of a fixed seed.
class Ar1Feed {
 public:
  explicit Ar1Feed(double correlation, unsigned seed = 1)
      : correlation_(correlation), random_(seed), z_(normal_(random_)) {}
  double next(const Normal& law) {
    const double now = z_;
    z_ = correlation_ * z_ + std::sqrt(1 - correlation_ * correlation_) * normal_(random_);
    return law.mean + law.sd * now;
  }

 private:
  double correlation_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0, 1};
  double z_;
};

}  // namespace tocsin::decision
