// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/drive.hpp"

#include <algorithm>

namespace tocsin::kobuki {
namespace {

constexpr std::size_t max_pending = 256;  // far more than 1 s of dead time holds at 50 Hz

double approach(double from, double to, double step) {
  return from + std::clamp(to - from, -step, step);
}

WheelSpeeds limited(WheelSpeeds speeds) {
  const double limit = max_speed_mps + max_turn_rate_rad_s * wheel_separation_m / 2.0;
  return {std::clamp(speeds.left_mps, -limit, limit), std::clamp(speeds.right_mps, -limit, limit)};
}

}  // namespace

void Drive::command(const BaseControl& control, Time now) {
  last_command_ = now;
  if (pending_.size() == max_pending) pending_.pop_front();
  pending_.push_back({now + seconds(params_.command_delay_s), limited(decode_velocity(control))});
}

void Drive::step(Time now, double dt_s) {
  while (!pending_.empty() && pending_.front().due <= now) {
    target_ = pending_.front().target;
    pending_.pop_front();
  }
  const bool timed_out = params_.command_timeout_s > 0 && last_command_ != Time::min() &&
                         now - last_command_ > seconds(params_.command_timeout_s);
  if (timed_out) target_ = {};
  const double change = params_.acceleration_mps2 * dt_s;
  speeds_.left_mps = approach(speeds_.left_mps, target_.left_mps, change);
  speeds_.right_mps = approach(speeds_.right_mps, target_.right_mps, change);
}

void Drive::reset() {
  pending_.clear();
  target_ = speeds_ = {};
  last_command_ = Time::min();
}

}  // namespace tocsin::kobuki
