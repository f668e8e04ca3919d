// SPDX-License-Identifier: Apache-2.0
#include "restart_rule.hpp"

#include <sysexits.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tocsin::cli {
namespace {

constexpr Duration up_after = std::chrono::seconds(5);
constexpr Duration window = std::chrono::seconds(60);

bool is_refusal(const Ending& ending) {
  return !ending.by_signal && (ending.code == 1 || ending.code == 2 || ending.code == 127);
}

/// By a signal, or by its watchdog, which exits with EX_TEMPFAIL of sysexits.h.
bool is_from_outside(const Ending& ending) {
  return ending.by_signal || ending.code == EX_TEMPFAIL;
}

}  // namespace

RestartDecision RestartRule::on_exit(const Ending& ending, Time now) {
  was_up_ = was_up_ || now - started_ >= up_after;
  if (!ending.by_signal && ending.code == 0) return {RestartDecision::Kind::finished};
  if (!was_up_ && is_refusal(ending)) {
    return {RestartDecision::Kind::refused, Duration{}, ending.code == 2 ? 2 : 1};
  }
  while (!restarts_.empty() && now - restarts_.front() >= window) restarts_.pop_front();
  const auto recent = static_cast<int>(restarts_.size());
  const bool limited = policy_.limit == 0 || !was_up_ || !is_from_outside(ending);
  if (limited && recent >= policy_.limit) return {RestartDecision::Kind::too_often, Duration{}, 1};
  restarts_.push_back(now);
  if (was_up_ && recent == 0) return {RestartDecision::Kind::restart};
  const double delay_s = std::ldexp(policy_.backoff_s, std::min(recent, 30));
  return {RestartDecision::Kind::restart, seconds(std::min(delay_s, policy_.max_backoff_s))};
}

}  // namespace tocsin::cli
