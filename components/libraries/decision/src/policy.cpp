// SPDX-License-Identifier: Apache-2.0
#include "decision/policy.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

/// `a - b` for a >= b, without overflow.
Duration since(Time a, Time b) {
  Duration::rep difference = 0;
  if (__builtin_sub_overflow(a.time_since_epoch().count(), b.time_since_epoch().count(),
                             &difference)) {
    return Duration::max();
  }
  return Duration{difference};
}

/// `a + b` for positive values, without overflow.
Duration saturating_sum(Duration a, Duration b) {
  return a > Duration::max() - b ? Duration::max() : a + b;
}

Time saturating_sum(Time a, Duration b) { return a > Time::max() - b ? Time::max() : a + b; }

}  // namespace

Policy::Policy(const char* name, const PolicyLimits& limits, std::unique_ptr<Rule> rule)
    : name_(name),
      th_max_samples_(limits.th_max_samples),
      th_max_(seconds(limits.th_max_s)),
      gap_(seconds(limits.gap_reset_s)),
      rule_(std::move(rule)) {
  std::ostringstream text;
  if (limits.th_max_samples < 1) {
    text << "policy.th_max_samples: " << limits.th_max_samples << " must be at least 1";
  } else if (!(limits.th_max_s > 0) || !(limits.gap_reset_s > 0)) {
    text << "policy.th_max_s and gap_reset_s: " << limits.th_max_s << " and " << limits.gap_reset_s
         << " must be above 0";
  }
  if (!text.str().empty()) throw ConfigError(text.str());
}

// The private steps are inline because position-independent code would otherwise call them.

/// Only steps forward count, so a clock that is set back cannot move the end of a pause away.
/// Returns true when the clock went back.
inline bool Policy::advance(Time now) {
  const bool back = now_ && now < *now_;
  const Duration step = now_ && !back ? since(now, *now_) : Duration{};
  now_ = now;
  unheard_ = saturating_sum(unheard_, step);
  if (state_ == State::passive) silent_ = saturating_sum(silent_, step);
  return back;
}

/// A stamp of the future is taken as `now`, lest it make all later samples look stale.
inline bool Policy::is_stale(Time stamp, bool clock_went_back) {
  const Time bounded = std::min(stamp, *now_);
  if (last_stamp_ && !clock_went_back && bounded < *last_stamp_) return true;
  last_stamp_ = bounded;
  return false;
}

inline bool Policy::pause_expired() const { return state_ == State::passive && silent_ >= th_max_; }

inline void Policy::limit_silence(Decision& decision) const {
  if (state_ == State::active || decision.change) return;
  if (age_ >= th_max_samples_) {
    decision.change = true;
    decision.reason = Reason::forced_resume_samples;
  } else if (pause_expired()) {
    decision.change = true;
    decision.reason = Reason::forced_resume_time;
  }
}

inline Evidence Policy::conclude(const Decision& decision, double qni) {
  Evidence evidence;
  evidence.age = age_;
  if (decision.change) {
    state_ = state_ == State::active ? State::passive : State::active;
    age_ = 0;
    silent_ = Duration{};
    rule_->entered(state_);
  }
  evidence.state = state_;
  evidence.changed = decision.change;
  evidence.reason = decision.reason;
  evidence.sample = qni;
  evidence.statistic = decision.statistic;
  evidence.threshold = decision.threshold;
  if (state_ == State::passive) evidence.deadline = saturating_sum(*now_, th_max_ - silent_);
  return evidence;
}

Evidence Policy::on_sample(const Sample& sample, Time now) {
  const bool back = advance(now);
  if (state_ == State::active && unheard_ > gap_) rule_->forget();
  const bool stale = is_stale(sample.stamp, back);
  const double qni = stale || !std::isfinite(sample.qni) ? nan : sample.qni;
  if (!std::isnan(qni)) unheard_ = Duration{};
  Decision decision =
      state_ == State::active ? rule_->while_active(qni) : rule_->while_passive(qni, ++age_);
  if (!decision.change && stale) decision.reason = Reason::stale_sample;
  if (!decision.change && !stale && std::isnan(qni)) decision.reason = Reason::no_measurement;
  limit_silence(decision);
  return conclude(decision, qni);
}

Evidence Policy::on_deadline(Time now) {
  advance(now);
  Decision decision;
  if (pause_expired()) decision = {true, Reason::forced_resume_time, 0, 0};
  return conclude(decision, nan);
}

}  // namespace tocsin::decision
