// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "decision/llr.hpp"
#include "decision/slot_costs.hpp"

namespace tocsin::decision {

/// A network that is good or bad and changes state at random between samples.
struct TwoStateChannel {
  double good_to_bad;  ///< per sample, in (0,1)
  double bad_to_good;  ///< per sample, in (0,1)
};

/// The probability that the network is bad, by Bayes's rule (the filter of a hidden Markov chain;
/// the recurrent form of Shiryaev's statistic).
class BeliefFilter {
 public:
  /// Starts as if the network had just been good. Throws ConfigError unless both are in (0,1).
  explicit BeliefFilter(const TwoStateChannel& channel);

  /// Takes the log-likelihood ratio of one sample; NaN when there was none. Returns the
  /// probability that the *next* slot is bad.
  double add(double l);
  [[nodiscard]] double predicted() const { return predicted_; }
  /// P(bad) at the last sample.
  [[nodiscard]] double posterior() const { return posterior_; }
  /// All evidence is void: back to the long-run share of bad slots.
  void forget();

 private:
  TwoStateChannel channel_;
  double predicted_;
  double posterior_ = 0;
};

/// When silence pays, by the age of silence: with age 0 (speaking) fall silent when the predicted
/// P(bad) is at least threshold[0]; at age a stay silent when it is at least threshold[a].
/// A threshold above 1 means "never". threshold[th_max] is not used: silence ends there.
struct BeliefThresholds {
  std::vector<double> threshold;
  int iterations;  ///< 0 for the myopic rule
};

/// Value iteration on (belief, age) with the costs, the two laws and the limit of silence;
/// optimal among causal rules when the channel is as assumed. Discount 0.999 per slot, belief on a
/// grid of 201. Takes well under a second; for construction only.
[[nodiscard]] BeliefThresholds solve_belief(const TwoStateChannel& channel, const SlotCosts& costs,
                                            const Density& good, const Density& bad,
                                            int th_max_samples);

/// The rule that is optimal without cost of change: silent when the predicted P(bad) is at least
/// silent_good / (send_bad + silent_good - silent_bad), at any age.
[[nodiscard]] BeliefThresholds myopic_belief(const SlotCosts& costs, int th_max_samples);

}  // namespace tocsin::decision
