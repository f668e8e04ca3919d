// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "decision/policy.hpp"

namespace tocsin::decision {

inline const Time t0{std::chrono::seconds(1000)};

inline PolicyParams params_for(const std::string& policy) {
  PolicyParams params;
  params.policy = value_of<PolicyKind>(policy).value();
  return params;
}

/// A dead zone of so many seconds, and a good link behind it.
inline Outlook dead_for(int s) {
  Outlook outlook;
  while (outlook.size < Outlook::most) {
    const bool is_dead = outlook.size < static_cast<std::size_t>(s);
    outlook.risk_percent[outlook.size++] = is_dead ? 95 : 2;
  }
  return outlook;
}

/// Feeds one sample per second.
class Feed {
 public:
  explicit Feed(const PolicyParams& params) : policy(make_policy(params)) {}
  Evidence operator()(double qni) {
    now += std::chrono::seconds(1);
    return policy->on_sample({now, qni}, now);
  }
  std::unique_ptr<Policy> policy;
  Time now = t0;
};

}  // namespace tocsin::decision
