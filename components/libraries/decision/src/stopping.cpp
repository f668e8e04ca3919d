// SPDX-License-Identifier: Apache-2.0
#include "decision/stopping.hpp"

#include <cassert>
#include <cmath>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

[[noreturn]] void reject(const char* name, double value, const char* allowed) {
  std::ostringstream text;
  text << name << ": " << value << " is outside " << allowed;
  throw ConfigError(text.str());
}

}  // namespace

Discount geometric_discount(double beta) {
  if (!(beta > 0 && beta <= 1)) reject("discount (geometric)", beta, "(0, 1]");
  return [beta](int k) { return std::pow(beta, k); };
}

Discount linear_discount(double gamma, int n) {
  if (!(gamma >= 0 && gamma <= 1)) reject("discount (linear)", gamma, "[0, 1]");
  if (n < 1) reject("candidates", n, "[1, 1000000]");
  return [gamma, n](int k) { return 1 - gamma * k / n; };
}

SecretaryRule secretary_with_threshold(int n, int r, const Discount& discount) {
  assert(1 <= r && r <= n);
  SecretaryRule rule{};
  rule.r_star = r;
  rule.p_stopped = 1 - (r - 1.0) / n;
  rule.expected_stop = r == 1 ? 1 : r - 1;
  if (r == 1) {
    rule.value = discount(1) / n;
    rule.p_best = 1.0 / n;
    return rule;
  }
  for (int k = r; k <= n; ++k) {
    const double share = (r - 1.0) / (k - 1.0);
    rule.expected_stop += share;
    rule.p_best += share / n;
    rule.value += discount(k) * share / n;
  }
  return rule;
}

SecretaryRule discounted_secretary(int n, const Discount& discount) {
  if (n < 1 || n > 1000000) reject("candidates", n, "[1, 1000000]");
  double later = 0;  // sum_{k=r+1}^N d(k)/(k-1), grown from the end
  int r = n;
  while (r > 1) {
    const double with_r = later + discount(r) / (r - 1.0);
    if (with_r > discount(r - 1)) break;
    later = with_r;
    --r;
  }
  return secretary_with_threshold(n, r, discount);
}

}  // namespace tocsin::decision
