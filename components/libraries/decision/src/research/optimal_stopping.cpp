// SPDX-License-Identifier: Apache-2.0
#include "decision/research/optimal_stopping.hpp"

#include <cmath>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

void require(bool ok, const char* name, double value, const char* allowed) {
  if (ok) return;
  std::ostringstream text;
  text << name << ": " << value << " is outside " << allowed;
  throw ConfigError(text.str());
}

void check(int n, double beta) {
  require(n >= 1, "candidates", n, "[1, inf)");
  require(beta > 0 && beta <= 1, "discount", beta, "(0, 1]");
}

/// The d of "i more to come": the root of a sum that falls in d, by bisection.
double indifference(int i, double beta) {
  const auto excess = [&](double d) {
    double sum = -1;
    double weight = std::pow(beta, i);
    double power = 1;
    for (int m = 1; m <= i; ++m, weight /= beta) {
      power /= d;
      sum += weight * (power - 1) / m;
    }
    return sum;
  };
  double low = 0;
  double high = 1;
  while (high - low > 1e-16) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return high;
}

/// P(the best of N is chosen at stage k), from the thresholds d_1 >= d_2 >= ... >= d_N = 0.
double win_at(const std::vector<double>& d, int k) {
  const int n = static_cast<int>(d.size());
  if (k == 1) return (1 - std::pow(d[0], n)) / n;
  const double dk = d[static_cast<std::size_t>(k) - 1];
  double sum = 0;
  for (int j = 1; j < k; ++j) {
    const double dj = d[static_cast<std::size_t>(j) - 1];
    sum += (std::pow(dj, n) - std::pow(dk, n)) / n +
           std::pow(dj, k - 1) * (1 - std::pow(dj, n - k + 1)) / (n - k + 1);
  }
  return sum / (k - 1);
}

/// E[max of k], from the integral of 1 - F^k by Simpson's rule.
double mean_maximum(const ValueLaw& law, int k) {
  constexpr int steps = 4000;
  const double h = (law.high - law.low) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double weight = i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * (1 - std::pow(law.cdf(law.low + i * h), k));
  }
  return law.low + sum * h / 3;
}

}  // namespace

StoppingSolution backward_induction(const StoppingProblem& problem) {
  require(problem.horizon >= 1, "horizon", problem.horizon, "[1, inf)");
  require(problem.states >= 1, "states", problem.states, "[1, inf)");
  const auto n = static_cast<std::size_t>(problem.horizon);
  const auto states = static_cast<std::size_t>(problem.states);
  StoppingSolution solution{{n, std::vector<double>(states)}, {n, std::vector<bool>(states)}};
  for (int k = problem.horizon; k >= 1; --k) {
    const auto row = static_cast<std::size_t>(k) - 1;
    for (std::size_t s = 0; s < states; ++s) {
      const int state = static_cast<int>(s);
      const double stop = problem.reward(k, state);
      double go_on = k == problem.horizon ? stop : 0;
      for (std::size_t t = 0; k < problem.horizon && t < states; ++t) {
        go_on += problem.transition(k, state, static_cast<int>(t)) * solution.value[row + 1][t];
      }
      solution.value[row][s] = std::max(stop, go_on);
      solution.stop[row][s] = stop >= go_on;
    }
  }
  return solution;
}

FullInformationRule full_information(int n, double beta) {
  check(n, beta);
  FullInformationRule rule{{}, 0, 0, 1};
  for (int k = 1; k < n; ++k) rule.threshold.push_back(indifference(n - k, beta));
  rule.threshold.push_back(0);
  for (int k = 1; k <= n; ++k) {
    const double win = win_at(rule.threshold, k);
    rule.p_best += win;
    rule.value += std::pow(beta, k) * win;
  }
  // nothing was accepted in k stages exactly if their maximum, at stage j, is below d_j
  for (int k = 1; k < n; ++k) {
    double sum = 0;
    for (int j = 0; j < k; ++j) sum += std::pow(rule.threshold[static_cast<std::size_t>(j)], k);
    rule.expected_stop += sum / k;
  }
  return rule;
}

MoserRule moser(int n, double beta, const ValueLaw& law) {
  check(n, beta);
  MoserRule rule{{}, beta * law.mean};
  for (int i = 1; i < n; ++i) {
    rule.reservation.insert(rule.reservation.begin(), rule.value);
    rule.value = beta * (rule.value + law.mean_excess(rule.value));
  }
  return rule;
}

BeardenRule bearden(int n, double beta, const ValueLaw& law) {
  check(n, beta);
  double go_on = std::pow(beta, n) * law.mean;
  BeardenRule rule{n, 0};
  for (int k = n - 1; k >= 1; --k) {
    const double stop = std::pow(beta, k) * mean_maximum(law, k);
    if (stop > go_on * (1 + 1e-9)) rule.r_star = k;
    go_on += std::max(stop - go_on, 0.0) / k;
  }
  rule.value = go_on;
  return rule;
}

ParkingRule parking(double p) {
  require(p >= 0 && p < 1, "parking p", p, "[0, 1)");
  int r = 0;
  double power = p;
  for (; power > 0.5; power *= p) ++r;
  return {r, r + 1 + (2 * power - 1) / (1 - p)};
}

}  // namespace tocsin::decision
