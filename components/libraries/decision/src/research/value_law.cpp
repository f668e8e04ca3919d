// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "decision/research/optimal_stopping.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

double excess(const Normal& law, double a) {
  const double z = (a - law.mean) / law.sd;
  return law.sd * (normal_density(z) - z * normal_cdf(-z));
}

double cdf(const Normal& law, double x) { return normal_cdf((x - law.mean) / law.sd); }

}  // namespace

ValueLaw uniform_law() {
  return {[](double x) { return std::clamp(x, 0.0, 1.0); },
          [](double a) {
            if (a <= 0) return 0.5 - a;
            return a >= 1 ? 0.0 : (1 - a) * (1 - a) / 2;
          },
          0, 1, 0.5};
}

ValueLaw normal_law(Normal law) { return mixture_law(law, law, 1); }

ValueLaw mixture_law(Normal first, Normal second, double share) {
  constexpr double spread = 10;
  return {[=](double x) { return share * cdf(first, x) + (1 - share) * cdf(second, x); },
          [=](double a) { return share * excess(first, a) + (1 - share) * excess(second, a); },
          std::min(first.mean - spread * first.sd, second.mean - spread * second.sd),
          std::max(first.mean + spread * first.sd, second.mean + spread * second.sd),
          share * first.mean + (1 - share) * second.mean};
}

}  // namespace tocsin::decision
