// SPDX-License-Identifier: Apache-2.0
#include "teleop_gamepad/teleop_gamepad_component.hpp"

#include <algorithm>
#include <utility>

#include "foundation/printable.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr int most_events = 256;  // in a tick: a broken pad must not hold it up

}  // namespace

TeleopGamepadComponent::TeleopGamepadComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      devices_(context.devices),
      teleop_(params.pad),
      sender_(params.sender),
      name_(operator_name(params.name, "gamepad")) {}

TeleopGamepadComponent::~TeleopGamepadComponent() {
  if (sender_.driving()) send({}, bus().now());
}

void TeleopGamepadComponent::tick(Time now) {
  if (!pad_) look_for_pad(now);
  if (pad_) read_events();
  watch_wheel();
  if (teleop_.take_start()) hand_over(now);
  sender_.hold(teleop_.velocity());
  if (const auto command = sender_.update(now)) send(*command, now);
  wake_at(std::min(sender_.next_deadline(), pad_ ? never : next_look_));
}

void TeleopGamepadComponent::look_for_pad(Time now) {
  if (now < next_look_) return;
  next_look_ = now + seconds(params_.retry_s);
  pad_ = devices_.open_gamepad(params_.device);
  if (pad_) {
    log().info("gamepad: {}", pad_->name());
    teleop_.on_connect(pad_->axes());
    wake_on(pad_->descriptor());
  } else if (!told_) {
    log().warn("waiting for a gamepad {}", params_.device);
  }
  told_ = !pad_;
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

void TeleopGamepadComponent::watch_wheel() {
  const auto driver = driver_.take_latest();
  if (!driver) return;
  wheel_ = {printable(driver->driver(), 60), printable(driver->asked_by(), 60)};
  const std::string text = wheel_text(wheel_, name_);
  if (!text.empty() && text != said_) log().info("{} (h: the start button)", text);
  said_ = text;
}

void TeleopGamepadComponent::hand_over(Time now) {
  const auto verb = handover_verb(wheel_, name_);
  if (!verb) return;
  topic::DriverRequest::Message message;
  message.stamp(wall(now));
  message.name(name_);
  message.verb(*verb);
  if (request_.write(std::move(message)) == Status::failed) log().warn("a request was not sent");
}

void TeleopGamepadComponent::send(const geometry::Twist& velocity, Time now) {
  topic::TeleopCmdVel::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id(name_);
  message.twist().linear().x(velocity.linear_mps);
  message.twist().angular().z(velocity.angular_rad_s);
  if (command_.write(std::move(message)) == Status::failed) log().warn("a velocity was not sent");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopGamepadComponent)
