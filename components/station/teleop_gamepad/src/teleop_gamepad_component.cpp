// SPDX-License-Identifier: Apache-2.0
#include "teleop_gamepad/teleop_gamepad_component.hpp"

#include <algorithm>
#include <utility>

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr int most_events = 256;  // in a tick: a broken pad must not hold it up

GamepadOpener opener_for(const Context& context) {
  if (context.devices == nullptr) return open_evdev_gamepad;
  return [](const std::string&) { return nullptr; };
}

}  // namespace

TeleopGamepadComponent::TeleopGamepadComponent(Context& context, const Params& params)
    : TeleopGamepadComponent(context, params, opener_for(context)) {}

TeleopGamepadComponent::TeleopGamepadComponent(Context& context, const Params& params,
                                               GamepadOpener opener)
    : Component(context),
      params_(params),
      opener_(std::move(opener)),
      teleop_(params.pad),
      sender_(params.sender) {}

TeleopGamepadComponent::~TeleopGamepadComponent() {
  if (sender_.driving()) send({}, bus().now());
}

void TeleopGamepadComponent::tick(Time now) {
  if (!port_) look_for_pad(now);
  if (port_) read_events();
  sender_.hold(teleop_.velocity());
  if (const auto command = sender_.update(now)) send(*command, now);
  wake_at(std::min(sender_.next_deadline(), port_ ? never : next_look_));
}

void TeleopGamepadComponent::look_for_pad(Time now) {
  if (now < next_look_) return;
  next_look_ = now + seconds(params_.retry_s);
  port_ = opener_(params_.device);
  if (port_) {
    log().info("gamepad: {}", port_->name());
    teleop_.on_connect(port_->axes());
    if (port_->descriptor() >= 0) wake_on(port_->descriptor());
  } else if (!told_) {
    log().warn("waiting for a gamepad {}", params_.device);
  }
  told_ = !port_;
}

void TeleopGamepadComponent::read_events() {
  PadEvent event;
  for (int i = 0; i < most_events; ++i) {
    switch (port_->read(event)) {
      case GamepadPort::Read::event:
        teleop_.on_event(event);
        break;
      case GamepadPort::Read::nothing:
        return;
      case GamepadPort::Read::lost:
        return lose_pad();
    }
  }
}

void TeleopGamepadComponent::lose_pad() {
  log().warn("the gamepad is gone");
  teleop_.on_disconnect();
  if (port_->descriptor() >= 0) forget(port_->descriptor());
  port_.reset();
}

void TeleopGamepadComponent::send(const geometry::Twist& velocity, Time now) {
  topic::TeleopCmdVel::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id("gamepad");
  message.twist().linear().x(velocity.linear_mps);
  message.twist().angular().z(velocity.angular_rad_s);
  if (command_.write(std::move(message)) == Status::failed) log().warn("a velocity was not sent");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopGamepadComponent)
