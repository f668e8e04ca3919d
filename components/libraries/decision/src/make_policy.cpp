// SPDX-License-Identifier: Apache-2.0
#include "decision/policy_model.hpp"
#include "decision/stopping.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/spelling.hpp"
#include "learning_rule.hpp"
#include "model_rules.hpp"
#include "policy_rules.hpp"

namespace tocsin::decision {
namespace {

int r_star(const PolicyParams& p) {
  const int n = p.th_max_samples;
  const Discount factor = p.discount == "linear" ? linear_discount(p.discount_value, n)
                                                 : geometric_discount(p.discount_value);
  return discounted_secretary(n, factor).r_star;
}

Reason alarm_of(const PolicyParams& p) {
  if (p.detector == "focus") return Reason::focus_alarm;
  return p.detector == "shiryaev_roberts" ? Reason::roberts_alarm : Reason::cusum_alarm;
}

Forward forward(const PolicyParams& p) {
  const Llr main = llr_of(p);
  const double mild = mild_alpha_of(p);
  return {detector_of(p), detector_threshold_of(p),         alarm_of(p),
          main,           mild > 0 ? mild_llr_of(p) : main, mild};
}

std::unique_ptr<Rule> belief_rule(const PolicyParams& p) {
  const TwoStateChannel channel{1 / p.mean_good_samples, 1 / p.mean_bad_samples};
  const BeliefThresholds thresholds =
      p.belief_myopic
          ? myopic_belief(p.costs(), p.th_max_samples)
          : solve_belief(channel, p.costs(), good_law_of(p), bad_law_of(p), p.th_max_samples);
  return std::make_unique<BeliefRule>(llr_of(p), channel, thresholds);
}

std::unique_ptr<Rule> threshold_rule(const PolicyParams& p) {
  return std::make_unique<ThresholdRule>(p.pause_below_qni, p.resume_at_qni, p.threshold_in_a_row);
}

struct Choice {
  const char* name;
  LearningRule::Maker make;
};

const Choice choices[] = {
    {"none",
     [](const PolicyParams&) -> std::unique_ptr<Rule> { return std::make_unique<AlwaysActive>(); }},
    {"threshold", threshold_rule},
    {"tocp",
     [](const PolicyParams& p) -> std::unique_ptr<Rule> {
       return std::make_unique<FixedPause>(forward(p), p.fixed_pause_samples);
     }},
    {"tocp_dsp",
     [](const PolicyParams& p) -> std::unique_ptr<Rule> {
       return std::make_unique<BestSoFar>(forward(p), r_star(p));
     }},
    {"tocp_reverse",
     [](const PolicyParams& p) -> std::unique_ptr<Rule> {
       return std::make_unique<ReverseCusum>(forward(p), reverse_alpha_of(p));
     }},
    {"belief", belief_rule},
    {"legacy",
     [](const PolicyParams& p) -> std::unique_ptr<Rule> {
       return std::make_unique<LegacyRule>(llr_of(p));
     }},
};

std::unique_ptr<Rule> rule_of(const PolicyParams& params, const Choice& choice) {
  if (params.laws == "fixed") return choice.make(params);
  return std::make_unique<LearningRule>(params, choice.make);
}

}  // namespace

std::unique_ptr<Policy> make_policy(const PolicyParams& params) {
  check(params);
  for (const Choice& choice : choices) {
    if (params.policy == choice.name) {
      return std::make_unique<Policy>(choice.name, params.limits(), rule_of(params, choice));
    }
  }
  throw ConfigError("policy.policy: '" + params.policy + "' is not one of: " +
                    joined_of(choices, [](const Choice& choice) { return choice.name; }) +
                    suggestion({policy_names.begin(), policy_names.end()}, params.policy));
}

std::unique_ptr<Policy> make_oracle(const std::vector<Slot>& slots, double change,
                                    int th_max_samples) {
  std::vector<Slot> later(slots);
  if (!later.empty()) later.erase(later.begin());
  std::vector<bool> send = clairvoyant(later, change, th_max_samples).send;
  send.insert(send.begin(), true);
  constexpr double year_s = 3.2e7;
  return std::make_unique<Policy>("oracle", PolicyLimits{th_max_samples, year_s, year_s},
                                  std::make_unique<ReplayRule>(std::move(send)));
}

}  // namespace tocsin::decision
