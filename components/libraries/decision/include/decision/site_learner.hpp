// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "decision/law_learner.hpp"
#include "decision/llr.hpp"
#include "decision/policy_params.hpp"

namespace tocsin::decision {

/// What was learned of a site's good link, and what that rests on.
struct LearnedLaw {
  Normal configured;
  Normal learned;
  Normal in_force;           ///< by which the policy decides
  double effective_samples;  ///< what the samples are worth, their correlation counted in
  double evidence;           ///< [standard errors] of the learned mean above the configured one
  double spread_evidence;    ///< [standard errors] of the logarithm of the spread
  double left_out_share;     ///< of all samples; a fault was suspected in them
  bool proposed;         ///< the site has another law than is configured, and by how much matters
  unsigned applied = 0;  ///< how often the law in force was changed
};

/// "good_mean 74.1, good_sd 7.2", as the parameters are called.
[[nodiscard]] std::string text_of(const Normal& good);
/// One line for people: what is proposed and on what evidence, or that what is configured stands.
[[nodiscard]] std::string text_of(const LearnedLaw& law);

/// Learns the law of a site's good link from all samples of a drive, pauses included, and says when
/// it is worth to decide by it.
///
/// What may be a fault is not learned: samples are left out while a CUSUM of the *configured* laws,
/// held at its threshold so that good samples end it at once, is at half of that threshold or
/// above. Since it does not know what was learned, what is learned cannot widen it. What slips
/// through is bounded by LawLearner. Constant time and memory, no allocation, no throw after
/// construction.
class SiteLearner {
 public:
  /// Throws ConfigError when the good law of the parameters is not normal, or their limits are
  /// none.
  explicit SiteLearner(const PolicyParams& params);

  /// Takes a quality; NaN is ignored.
  void add(double qni);
  /// The law that should be in force now, when it is another one than is: the learned law while it
  /// is proposed, else the configured one. Only while nothing is suspected, and seldom: a tenth of
  /// the memory after the last one.
  [[nodiscard]] std::optional<Normal> due() const;
  /// What became of due(): `law` is in force from now on; or it was refused, and the same waiting
  /// begins.
  void applied(const Normal& law);
  void refused() { since_ = 0; }
  /// Suspicion is void, after a gap.
  void forget() { suspicion_ = 0; }
  [[nodiscard]] LearnedLaw learned() const;

 private:
  [[nodiscard]] bool is_proposed() const;

  LawLearner learner_;
  Normal configured_;
  Normal in_force_;
  Llr llr_;
  double alpha_;
  double memory_;
  double suspicion_ = 0;
  double since_ = 0;  // samples since the law in force was changed or refused
  double taken_ = 0;
  double left_out_ = 0;
  unsigned applied_ = 0;
};

}  // namespace tocsin::decision
