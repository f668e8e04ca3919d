// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/teleop_keyboard_component.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "emergency_stop_input/hindrances.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr std::size_t longest_hindrance = 120;  // [1] characters

}  // namespace

TeleopKeyboardComponent::TeleopKeyboardComponent(Context& context, const Params& params)
    : TeleopComponent(context, params.common, "keyboard"),
      terminal_(context.devices().try_open<TerminalDevice>().device),
      teleop_(params.keys) {
  if (!terminal_) return;
  wake_on(terminal_->descriptor());
  terminal_->print(teleop_.help());
}

TeleopKeyboardComponent::~TeleopKeyboardComponent() { stop(); }

void TeleopKeyboardComponent::tick(Time now) {
  take_authority();
  if (terminal_) read_keys(now);
  if (auto safety = safety_.take_latest()) safety_seen_ = std::move(safety);
  if (auto location = location_.take_latest()) location_seen_ = std::move(location);
  const geometry::Twist velocity = teleop_.velocity(now);
  drive(velocity, now);
  if (terminal_) show(velocity);
  wake_at(std::min(next_command(), teleop_.next_deadline(now)));
}

void TeleopKeyboardComponent::read_keys(Time now) {
  if (const auto bytes = terminal_->read()) {
    teleop_.on_bytes(*bytes, now);
    const auto key = teleop_.take_control_key();
    if (key == KeyboardTeleop::ControlKey::hand_over) hand_over(now);
    if (key == KeyboardTeleop::ControlKey::take) take_control(now);
    if (key == KeyboardTeleop::ControlKey::keep) keep_control(now);
    return;
  }
  log().warn("no keys come any more");
  teleop_.on_end();
  forget(terminal_->descriptor());
  terminal_.reset();
}

void TeleopKeyboardComponent::show(const geometry::Twist& velocity) {
  std::string line =
      fmt::format("{:+.2f} m/s {:+.2f} rad/s   speeds {:.2f} m/s {:.2f} rad/s", velocity.linear_mps,
                  velocity.angular_rad_s, teleop_.linear_mps(), teleop_.angular_rad_s());
  if (location_seen_) {
    const auto& at = location_seen_->pose().pose().position();
    line += fmt::format("   at ({:.2f}, {:.2f}) m", at.x(), at.y());
  }
  const auto append = [&line](const std::string& text) {
    if (!text.empty()) line += "  " + text;
  };
  append(safety_seen_ ? printable(joined(hindrances(*safety_seen_)), longest_hindrance)
                      : "vehicle not received");
  append(authority_text({"h", "H", "n"}));
  if (line == shown_) return;
  terminal_->show(line);
  shown_ = line;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopKeyboardComponent)
