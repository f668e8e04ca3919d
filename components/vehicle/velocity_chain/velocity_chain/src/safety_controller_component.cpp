// SPDX-License-Identifier: Apache-2.0
#include "safety_controller/safety_controller_component.hpp"

#include <algorithm>
#include <utility>

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

/// Bits of core sensors by the index of an event: left, centre, right.
constexpr unsigned side_bits[] = {kobuki::left_bit, kobuki::centre_bit, kobuki::right_bit};
constexpr unsigned wheel_bits[] = {2, 1};  // left, right

template <std::size_t size>
void set(std::uint8_t& bits, const unsigned (&masks)[size], unsigned index, bool on) {
  if (index >= size) return;
  bits = static_cast<std::uint8_t>(on ? bits | masks[index] : bits & ~masks[index]);
}

bool same(const topic::SafetyStatus::Message& a, const topic::SafetyStatus::Message& b) {
  return a.emergency_stop() == b.emergency_stop() && a.bumper() == b.bumper() &&
         a.cliff() == b.cliff() && a.wheel_drop() == b.wheel_drop() && a.enabled() == b.enabled() &&
         a.stopped_by() == b.stopped_by();
}

}  // namespace

SafetyControllerComponent::SafetyControllerComponent(Context& context, const Params& params)
    : Component(context), file_(context.state_path(".stop")), controller_(params) {
  sensors_.emplace(*this);
  emergency_stop_.restore(file_.load(), bus().now());
  controller_.on_emergency_stop(emergency_stop_.stands());
  if (emergency_stop_.stands()) log().warn("the emergency stop stands, as before the restart");
}

void SafetyControllerComponent::tick(Time now) {
  take_state_at_start(now);
  take_events(now);
  take_emergency_stop(now);
  while (const auto enable = enable_.take()) controller_.set_enabled(enable->data());
  if (const auto wanted = wanted_.take_latest()) {
    send(controller_.on_wanted({wanted->linear().x(), wanted->angular().z()}, now));
  } else if (const auto velocity = controller_.update(now)) {
    send(*velocity);
  }
  report(now);
  wake_at(std::min(controller_.next_deadline(now), emergency_stop_.deadline()));
}

void SafetyControllerComponent::take_state_at_start(Time now) {
  if (!sensors_) return;
  const auto state = sensors_->take_latest();
  if (!state) return;
  hazards_ = {state->bumper(), state->cliff(), state->wheel_drop()};
  controller_.on_hazards(hazards_, now);
  sensors_.reset();
}

void SafetyControllerComponent::take_emergency_stop(Time now) {
  if (emergency_stop_.take(now)) controller_.on_emergency_stop(emergency_stop_.stands());
  if (!file_.save(emergency_stop_.memory())) {
    log().warn("the emergency stop cannot be kept for a restart");
  }
}

void SafetyControllerComponent::take_events(Time now) {
  const Hazards before = hazards_;
  while (const auto event = bumper_.take()) {
    set(hazards_.bumper, side_bits, event->bumper(), event->state() != 0);
  }
  while (const auto event = cliff_.take()) {
    set(hazards_.cliff, side_bits, event->sensor(), event->state() != 0);
  }
  while (const auto event = wheel_drop_.take()) {
    set(hazards_.wheel_drop, wheel_bits, event->wheel(), event->state() != 0);
  }
  const bool changed = before.bumper != hazards_.bumper || before.cliff != hazards_.cliff ||
                       before.wheel_drop != hazards_.wheel_drop;
  if (changed) controller_.on_hazards(hazards_, now);
}

void SafetyControllerComponent::send(const geometry::Twist& velocity) {
  topic::CmdVel::Message message;
  message.linear().x(velocity.linear_mps);
  message.angular().z(velocity.angular_rad_s);
  if (cmd_vel_.write(std::move(message)) == Status::failed) log().warn("a velocity was not sent");
}

void SafetyControllerComponent::report(Time now) {
  topic::SafetyStatus::Message message;
  message.stamp(wall(now));
  message.emergency_stop(controller_.emergency_stop());
  message.bumper(hazards_.bumper);
  message.cliff(hazards_.cliff);
  message.wheel_drop(hazards_.wheel_drop);
  message.enabled(controller_.enabled());
  message.stopped_by(emergency_stop_.stopped_by());
  if (reported_ && same(*reported_, message)) return;
  if (status_.write(message) != Status::failed) reported_ = message;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::SafetyControllerComponent)
