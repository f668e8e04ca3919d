// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/teleop_keyboard_component.hpp"

#include <fmt/format.h>

#include <utility>

#include "foundation/printable.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

/// What keeps the vehicle from driving, in a word; empty when nothing does.
std::string hindrance(const topic::SafetyStatus::Message& status) {
  if (status.emergency_stop()) return "  EMERGENCY STOP";
  if (status.wheel_drop() != 0) return "  wheel drop";
  if (status.cliff() != 0) return "  cliff";
  return status.bumper() != 0 ? "  bumper" : "";
}

}  // namespace

TeleopKeyboardComponent::TeleopKeyboardComponent(Context& context, const Params& params)
    : Component(context),
      terminal_(context.devices.get().open_terminal()),
      teleop_(params.keys),
      sender_(params.sender),
      name_(operator_name(params.name, "keyboard")) {
  if (!terminal_) return;
  wake_on(terminal_->descriptor());
  terminal_->print(teleop_.help());
}

TeleopKeyboardComponent::~TeleopKeyboardComponent() {
  if (sender_.driving()) send({}, bus().now());
}

void TeleopKeyboardComponent::tick(Time now) {
  if (terminal_) read_keys(now);
  if (auto safety = safety_.take_latest()) safety_seen_ = std::move(safety);
  if (const auto driver = driver_.take_latest()) {
    wheel_ = {printable(driver->driver(), 60), printable(driver->asked_by(), 60)};
  }
  if (auto location = location_.take_latest()) location_seen_ = std::move(location);
  const geometry::Twist velocity = teleop_.velocity(now);
  sender_.hold(velocity);
  if (const auto command = sender_.update(now)) send(*command, now);
  if (terminal_) show(velocity);
  wake_at(std::min(sender_.next_deadline(), teleop_.next_deadline(now)));
}

void TeleopKeyboardComponent::read_keys(Time now) {
  const auto bytes = terminal_->read();
  if (bytes) {
    teleop_.on_bytes(*bytes, now);
    const auto key = teleop_.take_wheel_key();
    if (key == 'n') return request("keep", now);
    const auto verb = key ? handover_verb(wheel_, name_) : std::nullopt;
    if (verb) request(*verb, now);
    return;
  }
  log().warn("no keys come any more");
  teleop_.on_end();
  forget(terminal_->descriptor());
  terminal_.reset();
}

void TeleopKeyboardComponent::request(const std::string& verb, Time now) {
  topic::DriverRequest::Message message;
  message.stamp(wall(now));
  message.name(name_);
  message.verb(verb);
  if (request_.write(std::move(message)) == Status::failed) log().warn("a request was not sent");
}

void TeleopKeyboardComponent::send(const geometry::Twist& velocity, Time now) {
  topic::TeleopCmdVel::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id(name_);
  message.twist().linear().x(velocity.linear_mps);
  message.twist().angular().z(velocity.angular_rad_s);
  if (command_.write(std::move(message)) == Status::failed) log().warn("a velocity was not sent");
}

void TeleopKeyboardComponent::show(const geometry::Twist& velocity) {
  std::string line =
      fmt::format("{:+.2f} m/s {:+.2f} rad/s   speeds {:.2f} m/s {:.2f} rad/s", velocity.linear_mps,
                  velocity.angular_rad_s, teleop_.linear_mps(), teleop_.angular_rad_s());
  if (location_seen_) {
    const auto& at = location_seen_->pose().pose().position();
    line += fmt::format("   at ({:.2f}, {:.2f}) m", at.x(), at.y());
  }
  line += safety_seen_ ? hindrance(*safety_seen_) : "  vehicle not heard";
  const std::string of_wheel = wheel_text(wheel_, name_);
  if (!of_wheel.empty()) line += "  " + of_wheel;
  if (line == shown_) return;
  terminal_->show(line);
  shown_ = line;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopKeyboardComponent)
