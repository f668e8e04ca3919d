// SPDX-License-Identifier: Apache-2.0
#include "teleop_gamepad/gamepad_teleop.hpp"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

// Before Linux 4.12 hid-sony numbered the buttons of a PlayStation 3 pad from BTN_JOYSTICK on, and
// L1 was the tenth: the number that turtlebot_teleop uses.
constexpr std::uint16_t old_ps3_l1 = BTN_JOYSTICK + 10;

}  // namespace

void GamepadTeleop::on_connect(const PadAxes& axes) {
  on_disconnect();
  axes_ = axes;
}

void GamepadTeleop::on_disconnect() {
  axes_.clear();
  positions_.clear();
  buttons_.clear();
}

bool GamepadTeleop::is_dead_man(std::uint16_t code) const {
  if (!is_generic()) return code == BTN_TL || code == old_ps3_l1;
  return code == BTN_TL || code == BTN_TR || code == BTN_TOP2 || code == BTN_PINKIE;
}

void GamepadTeleop::on_event(const PadEvent& event) {
  if (event.type == EV_SYN && event.code == SYN_DROPPED) {
    buttons_.clear();  // a release may be among the events that were lost
  } else if (event.type == EV_ABS) {
    positions_[event.code] = event.value;
  } else if (event.type == EV_KEY && event.code == BTN_START) {
    start_ = start_ || event.value == 1;
  } else if (event.type == EV_KEY && is_dead_man(event.code)) {
    if (event.value != 2) buttons_[event.code] = event.value == 1;  // 2: the kernel repeats it
  }
}

double GamepadTeleop::deflection(std::uint16_t axis) const {
  const auto range = axes_.find(axis);
  const auto position = positions_.find(axis);
  if (range == axes_.end() || position == positions_.end()) return 0;
  const double min = range->second.min;
  const double max = range->second.max;
  if (!(max > min)) return 0;
  const double way = std::clamp(2 * (position->second - min) / (max - min) - 1, -1.0, 1.0);
  const double beyond = std::abs(way) - params_.dead_zone;
  return beyond <= 0 ? 0 : std::copysign(beyond / (1 - params_.dead_zone), way);
}

geometry::Twist GamepadTeleop::velocity() const {
  const bool held = std::any_of(buttons_.begin(), buttons_.end(),
                                [](const auto& button) { return button.second; });
  if (!held) return {};
  double forward = -deflection(ABS_Y);  // axes grow downwards and to the right
  double left = -deflection(ABS_X);
  if (is_generic() && forward == 0 && left == 0) {
    forward = -deflection(ABS_HAT0Y);
    left = -deflection(ABS_HAT0X);
  }
  return {forward * params_.linear_mps, left * params_.angular_rad_s};
}

}  // namespace tocsin
