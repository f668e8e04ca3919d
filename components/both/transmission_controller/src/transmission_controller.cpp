// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/transmission_controller.hpp"

#include <algorithm>

#include "foundation/numbers.hpp"

namespace tocsin {

TransmissionController::TransmissionController(const Params& params)
    : index_(params.quality),
      policy_(decision::make_policy(params.policy)),
      timeout_(seconds(params.quality_timeout_s)),
      silence_is_poor_(params.silence_is_poor) {}

TransmissionDecision TransmissionController::on_quality(const decision::QniInput& measured,
                                                        Time now) {
  heard_ = now;
  silent_at_ = now + timeout_;
  const auto published = static_cast<float>(index_.evaluate(measured).value);
  return conclude(policy_->on_sample({now, published}, now), now);
}

std::optional<TransmissionDecision> TransmissionController::on_time(Time now) {
  if (heard_ && now >= silent_at_) {
    silent_at_ = now + timeout_;
    return conclude(policy_->on_sample({now, silence_is_poor_ ? 0.0 : nan}, now), now);
  }
  if (now >= pause_ends_) return conclude(policy_->on_deadline(now), now);
  return std::nullopt;
}

Time TransmissionController::deadline() const { return std::min(silent_at_, pause_ends_); }

TransmissionDecision TransmissionController::conclude(const decision::Evidence& evidence,
                                                      Time now) {
  pause_ends_ = evidence.deadline.value_or(never);
  if (evidence.changed) ++changes_;
  return {evidence, changes_, heard_ ? to_seconds(now - *heard_) : nan};
}

}  // namespace tocsin
