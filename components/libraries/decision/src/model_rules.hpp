// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "decision/belief.hpp"
#include "decision/policy.hpp"

namespace tocsin::decision {

/// Silent while the predicted probability of a bad slot is at least the threshold of the age.
class BeliefRule final : public Rule {
 public:
  BeliefRule(const Llr& llr, const TwoStateChannel& channel, BeliefThresholds thresholds);
  Decision while_active(double qni) override;
  Decision while_passive(double qni, int age) override;
  void entered(State) override {}  // what is known of the network does not hang on what we do
  void forget() override { filter_.forget(); }

 private:
  Llr llr_;
  BeliefFilter filter_;
  std::vector<double> threshold_;
};

/// What the thesis's source (ost.py, last commit) did, restated; a baseline. A drop is one sample
/// with ln f0/f1 <= 1; a pause ends when a counter is at 30, but changes within 3 samples of an
/// earlier one are not registered and leave the counter as it is, so that pauses last 30 or 32.
/// It knows no limit of silence: when Policy forces a slot to be spoken in, it goes on counting and
/// falls silent again until its own end.
class LegacyRule final : public Rule {
 public:
  explicit LegacyRule(const Llr& llr) : llr_(llr) {}
  Decision while_active(double qni) override;
  Decision while_passive(double qni, int age) override;
  void entered(State) override {}
  void forget() override {}

 private:
  void step(double qni);
  void start_segment();

  Llr llr_;
  bool active_ = true;
  int counter_ = 0;
  long round_ = -1;      // index of the sample
  long change_ = 0;      // index of the last registered change
  double sum_ = 0;       // of ln f0/f1 since then
  double last_sum_ = 0;  // as stored with the sample before
  double rise_ = 0;      // sum_ minus last_sum_ at the last sample
  bool before_ = true;   // the two decisions before this one
  bool before_that_ = true;
};

}  // namespace tocsin::decision
