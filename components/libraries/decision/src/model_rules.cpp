// SPDX-License-Identifier: Apache-2.0
#include "model_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tocsin::decision {

BeliefRule::BeliefRule(const Llr& llr, const TwoStateChannel& channel, BeliefThresholds thresholds)
    : llr_(llr), filter_(channel), threshold_(std::move(thresholds.threshold)) {}

Decision BeliefRule::while_active(double qni) {
  const double bad = filter_.add(llr_(qni));
  const bool pause = bad >= threshold_[0];
  return {pause, pause ? Reason::belief_bad : Reason::steady, bad, threshold_[0]};
}

Decision BeliefRule::while_passive(double qni, int age) {
  const double bad = filter_.add(llr_(qni));
  const auto row = std::min(static_cast<std::size_t>(age), threshold_.size() - 1);
  const bool last = row + 1 == threshold_.size();  // Policy ends the silence here
  const bool resume = !last && bad < threshold_[row];
  return {resume, resume ? Reason::belief_good : Reason::steady, bad, last ? 1 : threshold_[row]};
}

void LegacyRule::start_segment() {
  change_ = round_;
  sum_ = 0;
}

void LegacyRule::step(double qni) {
  constexpr int max_count = 30;
  ++round_;
  sum_ -= llr_(qni);
  const double stored = sum_;
  rise_ = stored - last_sum_;
  if (round_ - change_ > 1) {
    if (active_) {
      active_ = stored > last_sum_ + 1;
    } else {
      if (counter_ == max_count) {
        active_ = true;
        counter_ = 0;
        start_segment();
      }
      ++counter_;
    }
    const bool lone = active_ != before_ && active_ != before_that_;
    before_that_ = std::exchange(before_, active_);
    if (round_ - change_ > 3 && lone) {
      counter_ = 0;
      start_segment();
    }
  }
  last_sum_ = stored;
}

Decision LegacyRule::while_active(double qni) {
  if (std::isnan(qni)) return {};  // the source took no sample at all then
  step(qni);
  return {!active_, active_ ? Reason::steady : Reason::legacy_drop, rise_, 1};
}

Decision LegacyRule::while_passive(double qni, int) {
  if (std::isnan(qni)) return {};
  step(qni);
  return {active_, active_ ? Reason::legacy_count : Reason::steady, 1.0 * counter_, 30};
}

}  // namespace tocsin::decision
