// SPDX-License-Identifier: Apache-2.0
#include "decide.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::tools {
namespace {

using decision::Evidence;
using decision::Policy;
using decision::State;

std::unique_ptr<Policy> policy_for(const QualityTrace& trace, const std::string& policy,
                                   decision::PolicyParams& params) {
  if (policy == "oracle") {
    if (trace.bad.empty()) {
      throw ConfigError(trace.path + ": policy oracle needs the truth, a column state of 0 and 1");
    }
    return decision::make_oracle(slots_of(trace.bad, params.costs()), params.cost_change,
                                 params.th_max_samples);
  }
  if (!policy.empty()) params.policy = policy;
  return decision::make_policy(params);
}

bool forced(decision::Reason reason) {
  return reason == decision::Reason::forced_resume_samples ||
         reason == decision::Reason::forced_resume_time;
}

void add_costs(const DecidedTrace& decided, DecisionSummary& summary) {
  if (decided.trace.bad.size() < 2) return;
  const std::vector<bool> bad(decided.trace.bad.begin() + 1, decided.trace.bad.end());
  std::vector<bool> send;
  for (std::size_t n = 0; n + 1 < decided.evidence.size(); ++n) {
    send.push_back(decided.evidence[n].state == State::active);
  }
  const auto slots = slots_of(bad, decided.params.costs());
  summary.has_truth = true;
  summary.cost = cost_of(slots, decided.params.cost_change, send);
  summary.oracle_cost =
      clairvoyant(slots, decided.params.cost_change, decided.params.th_max_samples).cost;
}

}  // namespace

DecidedTrace decide_again(const QualityTrace& trace, const std::string& policy,
                          decision::PolicyParams params) {
  const auto decider = policy_for(trace, policy, params);
  DecidedTrace decided{trace, decider->name(), {}, params};
  std::optional<Time> deadline;
  for (std::size_t n = 0; n < trace.qni.size(); ++n) {
    const Time now{seconds(trace.time_s[n])};
    if (deadline && now > *deadline) (void)decider->on_deadline(*deadline);
    decided.evidence.push_back(decider->on_sample({now, trace.qni[n]}, now));
    deadline = decided.evidence.back().deadline;
  }
  return decided;
}

DecisionSummary summarize(const DecidedTrace& decided) {
  DecisionSummary summary;
  double active = 0;
  double sum_active = 0;
  double sum_passive = 0;
  bool was_passive = false;
  for (const Evidence& one : decided.evidence) {
    const bool passive = one.state == State::passive;
    ++summary.samples;
    summary.passive += passive;
    summary.pauses += passive && !was_passive;
    summary.forced += forced(one.reason);
    summary.longest_pause = std::max(summary.longest_pause, one.age);
    if (std::isnan(one.sample)) {
      ++summary.missing;
    } else {
      active += !passive;
      (passive ? sum_passive : sum_active) += one.sample;
    }
    was_passive = passive;
  }
  const double silent = static_cast<double>(summary.samples - summary.missing) - active;
  summary.mean_qni_active = active > 0 ? sum_active / active : std::nan("");
  summary.mean_qni_passive = silent > 0 ? sum_passive / silent : std::nan("");
  add_costs(decided, summary);
  return summary;
}

}  // namespace tocsin::tools
