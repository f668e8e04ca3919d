// SPDX-License-Identifier: Apache-2.0
#include "teleop_gamepad/teleop_gamepad_component.hpp"

#include <algorithm>

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr int most_events = 256;  // in a tick: a broken pad must not hold it up

}  // namespace

TeleopGamepadComponent::TeleopGamepadComponent(Context& context, const Params& params)
    : TeleopComponent(context, params.common, "gamepad"), params_(params), teleop_(params.pad) {}

TeleopGamepadComponent::~TeleopGamepadComponent() { stop(); }

void TeleopGamepadComponent::tick(Time now) {
  if (!pad_) look_for_pad(now);
  if (pad_) read_events();
  take_authority();
  log_authority();
  if (teleop_.take_start()) hand_over(now);
  drive(teleop_.velocity(), now);
  wake_at(std::min(next_command(), pad_ ? never : next_look_));
}

void TeleopGamepadComponent::look_for_pad(Time now) {
  if (now < next_look_) return;
  next_look_ = now + seconds(params_.retry_s);
  pad_ = context().devices().try_open<GamepadDevice>(params_.device).device;
  if (pad_) {
    log().info("gamepad: {}", pad_->name());
    teleop_.on_connect(pad_->axes());
    wake_on(pad_->descriptor());
  } else if (!is_missed_) {
    log().warn("waiting for a gamepad {}", params_.device);
  }
  is_missed_ = !pad_;
}

void TeleopGamepadComponent::read_events() {
  PadEvent event;
  for (int i = 0; i < most_events; ++i) {
    switch (pad_->read(event)) {
      case GamepadDevice::Read::event:
        teleop_.on_event(event);
        break;
      case GamepadDevice::Read::nothing:
        return;
      case GamepadDevice::Read::lost:
        return lose_pad();
    }
  }
}

void TeleopGamepadComponent::lose_pad() {
  log().warn("the gamepad is gone");
  teleop_.on_disconnect();
  forget(pad_->descriptor());
  pad_.reset();
}

void TeleopGamepadComponent::log_authority() {
  const std::string text = authority_text({"the start button", "", ""});
  if (!text.empty() && text != logged_) log().info("{}", text);
  logged_ = text;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopGamepadComponent)
