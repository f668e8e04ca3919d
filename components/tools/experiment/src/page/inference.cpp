// SPDX-License-Identifier: Apache-2.0
#include "page/inference.hpp"

#include <cassert>
#include <cmath>

namespace tocsin::experiment {

double t_quantile_975(int degrees) {
  assert(degrees >= 1);
  constexpr double exact[] = {12.7062, 4.30265, 3.18245, 2.77645};
  if (degrees <= 4) return exact[degrees - 1];
  const double v = degrees;
  const double z = 1.959963985;
  const double z2 = z * z;
  const double g1 = z * (z2 + 1) / 4;
  const double g2 = z * (5 * z2 * z2 + 16 * z2 + 3) / 96;
  const double g3 = z * (3 * z2 * z2 * z2 + 19 * z2 * z2 + 17 * z2 - 15) / 384;
  return z + g1 / v + g2 / (v * v) + g3 / (v * v * v);
}

Estimate estimate(const std::vector<double>& values) {
  double sum = 0;
  int runs = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++runs;
  }
  const double none = std::nan("");
  if (runs == 0) return {none, none, none, 0};
  const double mean = sum / runs;
  if (runs == 1) return {mean, none, none, 1};
  double squares = 0;
  for (const double value : values) {
    if (std::isfinite(value)) squares += (value - mean) * (value - mean);
  }
  const double half = t_quantile_975(runs - 1) * std::sqrt(squares / (runs - 1) / runs);
  return {mean, mean - half, mean + half, runs};
}

Estimate paired_difference(const std::vector<double>& a, const std::vector<double>& b) {
  assert(a.size() == b.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  return estimate(differences);
}

}  // namespace tocsin::experiment
