// SPDX-License-Identifier: Apache-2.0
#include "policy_rules.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::decision {

ThresholdRule::ThresholdRule(double pause_below, double resume_at, int in_a_row)
    : pause_below_(pause_below), resume_at_(resume_at), in_a_row_(in_a_row) {}

void ThresholdRule::count(double qni) {
  if (std::isnan(qni)) return;
  low_ = qni < pause_below_ ? std::min(low_ + 1, in_a_row_) : 0;
  high_ = qni >= resume_at_ ? std::min(high_ + 1, in_a_row_) : 0;
}

Decision ThresholdRule::while_active(double qni) {
  count(qni);
  const bool pause = low_ == in_a_row_ && !std::isnan(qni);
  return {pause, pause ? Reason::threshold_low : Reason::steady, qni, pause_below_};
}

Decision ThresholdRule::while_passive(double qni, int) {
  count(qni);
  const bool resume = high_ == in_a_row_ && !std::isnan(qni);
  return {resume, resume ? Reason::threshold_high : Reason::steady, qni, resume_at_};
}

Decision TocpRule::while_active(double qni) {
  const double w = forward_.detector->add(qni);
  const bool pause = w >= forward_.threshold;
  return {pause, pause ? forward_.alarm : Reason::steady, w, forward_.threshold};
}

void TocpRule::forget() { forward_.detector->reset(); }

void TocpRule::entered(State) { TocpRule::forget(); }

Decision FixedPause::while_passive(double, int age) {
  const bool over = age >= samples_;
  return {over, over ? Reason::fixed_pause_over : Reason::steady, 1.0 * age, 1.0 * samples_};
}

Decision BestSoFar::while_passive(double qni, int age) {
  const double bar = best_;
  const bool record = qni > best_;  // false for NaN
  if (record) best_ = qni;
  const bool stop = record && age >= r_star_;
  return {stop, stop ? Reason::best_so_far : Reason::steady, qni, bar};
}

void BestSoFar::entered(State state) {
  TocpRule::entered(state);
  best_ = -std::numeric_limits<double>::infinity();
}

Decision ReverseCusum::while_passive(double qni, int) {
  const double w = reverse_.add(-llr(qni));
  const bool good = reverse_.alarm(reverse_alpha_);
  return {good, good ? Reason::reverse_alarm : Reason::steady, w, reverse_alpha_};
}

void ReverseCusum::entered(State state) {
  TocpRule::entered(state);
  reverse_.reset();
}

}  // namespace tocsin::decision
