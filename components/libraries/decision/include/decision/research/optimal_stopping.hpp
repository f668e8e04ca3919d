// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "decision/cusum.hpp"

namespace tocsin::decision {

/// A stopping problem with stages 1..horizon and states 0..states-1.
struct StoppingProblem {
  int horizon;
  int states;
  std::function<double(int stage, int state)> reward;  ///< for stopping; forced at the horizon
  /// Probability of `next` at stage + 1 when going on.
  std::function<double(int stage, int state, int next)> transition;
};

/// Value and best action of every stage and state; index [stage - 1][state].
struct StoppingSolution {
  std::vector<std::vector<double>> value;
  std::vector<std::vector<bool>> stop;  ///< stops on a tie
};

/// Backward induction, equations (9) to (11) of the thesis: V_N = y_N,
/// V_k = max(y_k, E[V_{k+1} | state]). Throws ConfigError unless horizon and states are positive.
[[nodiscard]] StoppingSolution backward_induction(const StoppingProblem& problem);

/// "Choose the best of N" when the law F of the values is known and the payoff is beta^k.
struct FullInformationRule {
  /// Accept a best-so-far x at stage k when F(x) >= threshold[k - 1]; falls to 0 at stage N.
  std::vector<double> threshold;
  double value;          ///< E[beta^tau 1{the best was chosen}]
  double p_best;         ///< probability that the best is chosen
  double expected_stop;  ///< mean stopping stage, N when nothing was accepted
};

/// Gilbert and Mosteller (1966) with a discount: d_k, i = N - k, solves
/// sum_{m=1}^i beta^{i+1-m} (d^-m - 1)/m = 1. Throws ConfigError unless n >= 1, 0 < beta <= 1.
[[nodiscard]] FullInformationRule full_information(int n, double beta);

/// A law of values for cardinal payoffs.
struct ValueLaw {
  std::function<double(double)> cdf;
  std::function<double(double)> mean_excess;  ///< E max(X - a, 0)
  double low;                                 ///< practically nothing below
  double high;                                ///< practically nothing above
  double mean;
};

[[nodiscard]] ValueLaw uniform_law();
[[nodiscard]] ValueLaw normal_law(Normal law);
/// `share` of the first law, the rest of the second.
[[nodiscard]] ValueLaw mixture_law(Normal first, Normal second, double share);

/// Moser's problem: the payoff is beta^k X_k, the last must be taken.
struct MoserRule {
  std::vector<double> reservation;  ///< accept x at stage k < N when x >= reservation[k - 1]
  double value;                     ///< E[beta^tau X_tau]
};

/// a_1 = beta EX, a_i = beta E max(X, a_{i-1}); the reservation of stage k is a_{N-k}.
/// Throws ConfigError unless n >= 1 and 0 < beta <= 1.
[[nodiscard]] MoserRule moser(int n, double beta, const ValueLaw& law);

/// Bearden's problem (2006) with a discount: only "best so far" is seen, but the payoff is
/// beta^k X_k and the last must be taken.
struct BeardenRule {
  int r_star;    ///< the first stage whose record is accepted; on a tie it waits
  double value;  ///< E[beta^tau X_tau]
};

/// By dynamic programming over E[max of k], which are integrated numerically (1e-6).
[[nodiscard]] BeardenRule bearden(int n, double beta, const ValueLaw& law);

/// The parking problem: places before the theatre are free with probability 1 - p.
struct ParkingRule {
  int r;        ///< start to look r places before the theatre
  double cost;  ///< expected walk, in places
};

/// Equation (14) of the thesis: P_r = r + 1 + (2 p^{r+1} - 1)/(1 - p), least at the first r with
/// p^{r+1} <= 1/2. Throws ConfigError unless 0 <= p < 1.
[[nodiscard]] ParkingRule parking(double p);

}  // namespace tocsin::decision
