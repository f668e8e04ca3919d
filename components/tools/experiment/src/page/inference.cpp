// SPDX-License-Identifier: Apache-2.0
#include "page/inference.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <map>

namespace tocsin::experiment {

double t_quantile_975(int degrees) {
  assert(degrees >= 1);
  return quantile(boost::math::students_t(degrees), 0.975);
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

Estimate estimate_over_groups(const std::vector<double>& values, const std::vector<int>& group) {
  assert(values.size() == group.size());
  std::map<int, std::vector<double>> members;
  for (std::size_t i = 0; i < values.size(); ++i) members[group[i]].push_back(values[i]);
  std::vector<double> means;
  for (const auto& [number, all] : members) means.push_back(estimate(all).mean);
  return estimate(means);
}

Estimate paired_difference(const std::vector<double>& a, const std::vector<double>& b) {
  assert(a.size() == b.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  return estimate(differences);
}

}  // namespace tocsin::experiment
