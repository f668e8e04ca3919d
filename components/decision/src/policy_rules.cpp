// SPDX-License-Identifier: Apache-2.0
#include "policy_rules.hpp"

#include "decision/stopping.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {

ThresholdRule::ThresholdRule(double pause_below, double resume_at, int in_a_row)
    : pause_below_(pause_below), resume_at_(resume_at), in_a_row_(in_a_row) {}

Verdict ThresholdRule::while_active(double qni) {
  if (std::isnan(qni)) return {false, Reason::steady, qni, pause_below_};
  agreeing_ = qni < pause_below_ ? agreeing_ + 1 : 0;
  const bool pause = agreeing_ >= in_a_row_;
  return {pause, pause ? Reason::threshold_low : Reason::steady, qni, pause_below_};
}

Verdict ThresholdRule::while_passive(double qni, int) {
  if (std::isnan(qni)) return {false, Reason::steady, qni, resume_at_};
  agreeing_ = qni >= resume_at_ ? agreeing_ + 1 : 0;
  const bool resume = agreeing_ >= in_a_row_;
  return {resume, resume ? Reason::threshold_high : Reason::steady, qni, resume_at_};
}

Verdict TocpRule::while_active(double qni) {
  const double w = cusum_.add(llr_(qni));
  const bool alarm = cusum_.alarm(alpha_);
  return {alarm, alarm ? Reason::cusum_alarm : Reason::steady, w, alpha_};
}

void TocpRule::entered(State) { cusum_.reset(); }

Verdict FixedPause::while_passive(double, int age) {
  const bool over = age >= samples_;
  return {over, over ? Reason::fixed_pause_over : Reason::steady, 1.0 * age, 1.0 * samples_};
}

Verdict BestSoFar::while_passive(double qni, int age) {
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

Verdict ReverseCusum::while_passive(double qni, int) {
  const double w = reverse_.add(-llr(qni));
  const bool good = reverse_.alarm(reverse_alpha_);
  return {good, good ? Reason::reverse_alarm : Reason::steady, w, reverse_alpha_};
}

void ReverseCusum::entered(State state) {
  TocpRule::entered(state);
  reverse_.reset();
}

namespace {

int r_star(const PolicyParams& p) {
  const int n = p.th_max_samples;
  const Discount discount = p.discount == "linear" ? linear_discount(p.discount_value, n)
                                                   : geometric_discount(p.discount_value);
  return discounted_secretary(n, discount).r_star;
}

template <class Kind, class... Args>
std::unique_ptr<Policy> with_rule(const char* name, const PolicyParams& params, Args... args) {
  return std::make_unique<Policy>(name, params.limits(), std::make_unique<Kind>(args...));
}

std::unique_ptr<Policy> make_tocp(const PolicyParams& p) {
  const NormalLlr llr({p.good_mean, p.good_sd}, {p.bad_mean, p.bad_sd}, p.llr_clip);
  if (p.policy == "tocp_dsp") return with_rule<BestSoFar>("tocp_dsp", p, llr, p.alpha, r_star(p));
  if (p.policy == "tocp_reverse") {
    return with_rule<ReverseCusum>("tocp_reverse", p, llr, p.alpha, p.reverse_alpha);
  }
  if (p.policy == "tocp") {
    return with_rule<FixedPause>("tocp", p, llr, p.alpha, p.fixed_pause_samples);
  }
  throw ConfigError("policy.policy: '" + p.policy +
                    "' is not one of: none, threshold, tocp, tocp_dsp, tocp_reverse");
}

}  // namespace

std::unique_ptr<Policy> make_policy(const PolicyParams& params) {
  check(params);
  if (params.policy == "none") return with_rule<AlwaysActive>("none", params);
  if (params.policy == "threshold") {
    return with_rule<ThresholdRule>("threshold", params, params.pause_below_qni,
                                    params.resume_at_qni, params.threshold_in_a_row);
  }
  return make_tocp(params);
}

}  // namespace tocsin::decision
