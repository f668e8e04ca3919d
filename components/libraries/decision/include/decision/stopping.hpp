// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace tocsin::decision {

/// Worth d(k) of stopping at candidate k = 1..N. Must not be negative nor increase with k.
using Discount = std::function<double(int)>;

/// d(k) = beta^k, 0 < beta <= 1; beta = 1 is the plain secretary problem.
/// Throws ConfigError outside that range.
[[nodiscard]] Discount geometric_discount(double beta);

/// d(k) = 1 - gamma k / n, 0 <= gamma <= 1: the discount behind "LDS" in the thesis's source.
/// Throws ConfigError outside that range.
[[nodiscard]] Discount linear_discount(double gamma, int n);

/// The optimal rule for "stop on the best of N, seen one at a time, only ranks known":
/// pass the first r_star - 1 candidates, then stop at the first that beats all before it.
struct SecretaryRule {
  int r_star;            ///< first candidate (from 1) that may be accepted
  double value;          ///< E[d(tau) 1{the best was chosen}]
  double p_best;         ///< probability that the best of the N is chosen
  double p_stopped;      ///< probability that some candidate is accepted before N runs out
  double expected_stop;  ///< mean stopping index, counting N when nothing was accepted
};

/// Exact for every discount that makes the problem monotone, as the geometric and the linear do:
/// r* = min{ r >= 1 : sum_{k=r+1}^N d(k)/(k-1) <= d(r) }   (Rasmussen & Pliska for d = beta^k),
/// V = (r*-1)/N sum_{k=r*}^N d(k)/(k-1), and d(1)/N for r* = 1.
/// Throws ConfigError unless n is in [1, 1000000].
[[nodiscard]] SecretaryRule discounted_secretary(int n, const Discount& discount);

/// The same quantities for any r, not only the best: what a wrong threshold costs. 1 <= r <= n.
[[nodiscard]] SecretaryRule secretary_with_threshold(int n, int r, const Discount& discount);

}  // namespace tocsin::decision
