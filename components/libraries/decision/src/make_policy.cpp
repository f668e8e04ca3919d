// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "decision/policy_model.hpp"
#include "decision/stopping.hpp"
#include "foresight_rule.hpp"
#include "model_rules.hpp"
#include "policy_rules.hpp"

namespace tocsin::decision {
namespace {

int r_star(const PolicyParams& p) {
  const int n = p.th_max_samples;
  const Discount factor = p.discount == DiscountKind::linear ? linear_discount(p.discount_value, n)
                                                             : geometric_discount(p.discount_value);
  return discounted_secretary(n, factor).r_star;
}

Forward forward(const PolicyParams& p) {
  const bool cusum = p.detector == DetectorKind::cusum;
  return {detector_of(p), detector_threshold_of(p),
          cusum ? Reason::cusum_alarm : Reason::detector_alarm, llr_of(p)};
}

std::unique_ptr<Rule> belief_rule(const PolicyParams& p) {
  const TwoStateChannel channel{1 / p.mean_good_samples, 1 / p.mean_bad_samples};
  const BeliefThresholds thresholds =
      p.belief_myopic
          ? myopic_belief(p.costs(), p.th_max_samples)
          : solve_belief(channel, p.costs(), good_law_of(p), bad_law_of(p), p.th_max_samples);
  return std::make_unique<BeliefRule>(llr_of(p), channel, thresholds);
}

std::unique_ptr<Rule> foresight_rule(const PolicyParams& p) {
  std::unique_ptr<Rule> otherwise = std::make_unique<AlwaysActive>();
  if (p.foresight_fallback == FallbackKind::tocp_dsp) {
    otherwise = std::make_unique<BestSoFar>(forward(p), r_star(p));
  }
  const ForesightRule::Costs costs{p.foresight_wait_cost, p.foresight_correlation_s};
  return std::make_unique<ForesightRule>(llr_of(p), costs, std::move(otherwise));
}

std::unique_ptr<Rule> rule_of(const PolicyParams& p) {
  switch (p.policy) {
    case PolicyKind::none:
      return std::make_unique<AlwaysActive>();
    case PolicyKind::threshold:
      return std::make_unique<ThresholdRule>(p.pause_below_qni, p.resume_at_qni,
                                             p.threshold_in_a_row);
    case PolicyKind::tocp:
      return std::make_unique<FixedPause>(forward(p), p.fixed_pause_samples);
    case PolicyKind::tocp_dsp:
      return std::make_unique<BestSoFar>(forward(p), r_star(p));
    case PolicyKind::tocp_reverse:
      return std::make_unique<ReverseCusum>(forward(p), reverse_alpha_of(p));
    case PolicyKind::belief:
      return belief_rule(p);
    case PolicyKind::legacy:
      return std::make_unique<LegacyRule>(llr_of(p));
    case PolicyKind::foresight:
      return foresight_rule(p);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<Policy> make_policy(const PolicyParams& params) {
  check(params);
  return std::make_unique<Policy>(word_of(params.policy), params.limits(), rule_of(params));
}

}  // namespace tocsin::decision
