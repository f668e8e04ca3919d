// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "decision/run_length.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

struct Quadrature {
  std::vector<double> node;
  std::vector<double> weight;
};

/// Gauss-Legendre on [0, length]: zeros of P_n by Newton's method.
Quadrature gauss_legendre(int n, double length) {
  Quadrature rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(M_PI * (i + 0.75) / (n + 0.5));
    double slope = 1;
    for (int step = 0; step < 30; ++step) {
      double p = 1;
      double before = 0;
      for (int j = 1; j <= n; ++j)
        before = std::exchange(p, ((2 * j - 1) * x * p - (j - 1) * before) / j);
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.node.push_back(length * (1 + x) / 2);
    rule.weight.push_back(length / ((1 - x * x) * slope * slope));
  }
  return rule;
}

using Matrix = std::vector<std::vector<double>>;  // rows with the right side as last column

/// Gauss elimination with row exchange; the unknowns are left in the last column.
void solve(Matrix& m) {
  const std::size_t n = m.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r) {
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    }
    std::swap(m[c], m[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double f = m[r][c] / m[c][c];
      for (std::size_t k = c; k <= n; ++k) m[r][k] -= f * m[c][k];
    }
  }
  for (std::size_t r = 0; r < n; ++r) m[r][n] /= m[r][r];
}

}  // namespace

double gaussian_run_length(double k, double h, double mu) {
  const double drift = mu - k;
  const Quadrature rule = gauss_legendre(24 + static_cast<int>(10 * h), h);
  const std::size_t n = rule.node.size();
  // unknowns: L at 0 and at the nodes; L(z) = 1 + L(0) F(-z) + int_0^h L(y) f(y - z) dy
  Matrix m(n + 1, std::vector<double>(n + 2, 1.0));
  for (std::size_t r = 0; r <= n; ++r) {
    const double z = r == 0 ? 0 : rule.node[r - 1];
    m[r][0] = -normal_cdf(-z - drift);
    for (std::size_t c = 1; c <= n; ++c) {
      m[r][c] = -rule.weight[c - 1] * normal_density(rule.node[c - 1] - z - drift);
    }
    m[r][r] += 1;
  }
  solve(m);
  return m[0][n + 1];
}

double gaussian_run_length_two_sided(double k, double h, double mu) {
  return 1 / (1 / gaussian_run_length(k, h, mu) + 1 / gaussian_run_length(k, h, -mu));
}

}  // namespace tocsin::decision
