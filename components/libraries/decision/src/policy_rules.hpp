// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <utility>

#include "decision/detectors.hpp"
#include "decision/llr.hpp"
#include "decision/policy.hpp"

namespace tocsin::decision {

/// Never pauses; the baseline.
class AlwaysActive final : public Rule {
 public:
  Decision while_active(double) override { return {}; }
  Decision while_passive(double, int) override { return {true, Reason::steady, 0, 0}; }
  void entered(State) override {}
  void forget() override {}
};

/// Two bounds with hysteresis; the last `in_a_row` samples must all lie beyond a bound. They are
/// counted in either state, so that a forced slot in a bad network stays a single one.
class ThresholdRule final : public Rule {
 public:
  ThresholdRule(double pause_below, double resume_at, int in_a_row);
  Decision while_active(double qni) override;
  Decision while_passive(double qni, int age) override;
  void entered(State) override {}
  void forget() override { low_ = high_ = 0; }

 private:
  void count(double qni);

  double pause_below_;
  double resume_at_;
  int in_a_row_;
  int low_ = 0;
  int high_ = 0;
};

/// What the detector of a turn to bad needs.
struct Forward {
  std::unique_ptr<Detector> detector;
  double threshold;
  Reason alarm;  ///< what the detector's alarm is called
  Llr llr;
};

/// TOCP: pauses at the alarm of its detector, the log-likelihood CUSUM or another. Derived rules
/// say when to resume.
class TocpRule : public Rule {
 public:
  explicit TocpRule(Forward forward) : forward_(std::move(forward)) {}
  Decision while_active(double qni) final;
  void entered(State state) override;
  void forget() override;

 protected:
  [[nodiscard]] double llr(double qni) const { return forward_.llr(qni); }

 private:
  Forward forward_;
};

/// Resumes after a pause of fixed length.
class FixedPause final : public TocpRule {
 public:
  FixedPause(Forward forward, int samples) : TocpRule(std::move(forward)), samples_(samples) {}
  Decision while_passive(double qni, int age) override;

 private:
  int samples_;
};

/// DSP: resumes on the first sample from candidate r* on that is the best of the pause.
class BestSoFar final : public TocpRule {
 public:
  BestSoFar(Forward forward, int r_star) : TocpRule(std::move(forward)), r_star_(r_star) {}
  Decision while_passive(double qni, int age) override;
  void entered(State state) override;

 private:
  int r_star_;
  double best_ = -std::numeric_limits<double>::infinity();
};

/// Resumes when a CUSUM on -l says that the network has turned good.
class ReverseCusum final : public TocpRule {
 public:
  ReverseCusum(Forward forward, double reverse_alpha)
      : TocpRule(std::move(forward)), reverse_alpha_(reverse_alpha) {}
  Decision while_passive(double qni, int age) override;
  void entered(State state) override;

 private:
  double reverse_alpha_;
  Cusum reverse_;
};

}  // namespace tocsin::decision
