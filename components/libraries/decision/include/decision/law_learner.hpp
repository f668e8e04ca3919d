// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "decision/cusum.hpp"

namespace tocsin::decision {

/// How fast and how far a law may be learned.
struct LearnerLimits {
  double memory_samples = 1800;  ///< [1] older samples fade; half an hour at one a second
  double max_shift_sd = 2;       ///< [1] the mean stays so near to where it started
  double max_spread = 2;         ///< [1] and the spread within this factor
};

/// Learns the normal law of a good link while it is used: Huber's M-estimates of mean and spread
/// (location with k = 1.5, proposal 2 for the scale), one small step for each sample.
///
/// Never faster than a fault: a sample moves the mean by at most 1.74 sd / memory_samples, however
/// bad it is, so that 60 s of a dead link move it by 0.06 sd with the default memory; and mean and
/// spread stay within their limits for ever. Constant time and memory, no allocation, no throw.
class LawLearner {
 public:
  /// Throws ConfigError unless its spread, the memory and the limits are positive, and max_spread
  /// is at least 1.
  explicit LawLearner(Normal start, const LearnerLimits& limits = {});

  /// Takes a quality while nothing is suspected of the link; NaN is ignored. Leave out those for
  /// which a detector is near its alarm, and those of pauses: they are not of a good link.
  void add(double qni);

  [[nodiscard]] Normal law() const { return law_; }
  /// What the samples are worth to the mean, their correlation and the memory counted in.
  [[nodiscard]] double effective_samples() const;
  /// How many standard errors the learned mean lies above where it started: beyond +-3 the site has
  /// another law than was configured. 0 before ten effective samples.
  [[nodiscard]] double evidence() const;
  /// The same of the logarithm of the spread.
  [[nodiscard]] double spread_evidence() const;

 private:
  Normal start_;
  LearnerLimits limits_;
  Normal law_;
  double samples_ = 0;
  double before_ = 0;   // the clipped deviation of the last sample
  double product_ = 0;  // mean product of neighbours
};

}  // namespace tocsin::decision
