// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/transmission_controller_component.hpp"

#include <cmath>
#include <limits>

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

float remaining_s(const std::optional<Time>& deadline, Time now) {
  return deadline ? static_cast<float>(to_seconds(*deadline - now))
                  : std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

TransmissionControllerComponent::TransmissionControllerComponent(Context& context,
                                                                 const Params& params)
    : Component(context),
      controller_(params.controller),
      heartbeat_period_(seconds(params.heartbeat_period_s)) {
  const bool looks = params.controller.policy.policy == decision::PolicyKind::foresight;
  if (looks && context.role == Role::uxv) ahead_.emplace(*this, params.foresight_speed_mps);
}

void TransmissionControllerComponent::tick(Time now) {
  if (ahead_) controller_.foresee(outlook_ = ahead_->outlook(now));
  while (const auto quality = quality_.take()) {
    const auto measured = decision::qni_input(quality->per_percent(), quality->signal_dbm(),
                                              quality->quality_percent());
    publish(controller_.on_quality(measured, now), now);
  }
  if (const auto decision = controller_.on_time(now)) publish(*decision, now);
  if (now >= next_beat_) beat(now);
  wake_at(std::min(controller_.deadline(), next_beat_));
}

void TransmissionControllerComponent::publish(const TransmissionDecision& decision, Time now) {
  const decision::Evidence& evidence = decision.evidence;
  tocsin_msgs::msg::TransmissionState message;
  message.stamp(wall(now));
  message.role(to_string(context().role));
  message.active(evidence.state == decision::State::active);
  message.policy(controller_.policy_name());
  message.reason(decision::to_string(evidence.reason));
  message.decision(decision.changes);
  message.qni(static_cast<float>(evidence.sample));
  message.statistic(static_cast<float>(evidence.statistic));
  message.threshold(static_cast<float>(evidence.threshold));
  message.pause_samples(static_cast<std::uint32_t>(evidence.age));
  message.deadline_s(remaining_s(evidence.deadline, now));
  message.quality_age_s(static_cast<float>(decision.quality_age_s));
  const auto& risks = outlook_.risk_percent;
  message.outlook().assign(risks.begin(), risks.begin() + outlook_.size);
  if (evidence.changed) {
    log().info("{}: {} (QNI {:.1f})", message.active() ? "active" : "passive", message.reason(),
               evidence.sample);
  }
  if (state_.write(std::move(message)) == Status::failed) log().warn("a decision was not sent");
}

void TransmissionControllerComponent::beat(Time now) {
  next_beat_ = next_instant(heartbeat_period_, now);
  tocsin_msgs::msg::Heartbeat message;
  message.stamp(wall(now));
  message.role(to_string(context().role));
  message.count(++beats_);
  if (heartbeat_.write(std::move(message)) == Status::failed) log().warn("no heartbeat was sent");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TransmissionControllerComponent)
