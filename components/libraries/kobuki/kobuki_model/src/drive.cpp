// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/drive.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::kobuki {
namespace {

constexpr std::size_t max_pending = 256;  // far more than 1 s of dead time holds at 50 Hz

/// Moves `speed` towards `target`, at most by `change`, at a steady rate. Returns its mean.
double approach(double& speed, double target, double change) {
  const double moved = std::clamp(target - speed, -change, change);
  speed += moved;
  // Once there it stays, so that only part of the time, |moved| / change, went on the ramp.
  return speed - moved * std::abs(moved) / (2.0 * change);
}

bool same(const BaseControl& a, const BaseControl& b) {
  return a.speed_mm_s == b.speed_mm_s && a.radius_mm == b.radius_mm;
}

/// A base is specified to end at 0.70 m/s and at 180 degrees/s. How its firmware cuts what is more
/// is unknown; here the radius is kept, and no wheel is faster than 0.70 m/s.
WheelSpeeds limited(const WheelSpeeds& speeds) {
  const double fastest_mps = std::max(std::abs(speeds.left_mps), std::abs(speeds.right_mps));
  const double turn_rad_s = std::abs(body_velocity(speeds).angular_rad_s);
  const double excess =
      std::max({1.0, fastest_mps / max_speed_mps, turn_rad_s / max_turn_rate_rad_s});
  return {speeds.left_mps / excess, speeds.right_mps / excess};
}

}  // namespace

void Drive::command(const BaseControl& control, Time now) {
  last_command_ = now;
  if (newest_ && same(*newest_, control)) return;
  newest_ = control;
  if (pending_.size() == max_pending) pending_.pop_front();
  pending_.push_back({now + seconds(params_.command_delay_s), limited(decode_velocity(control))});
}

Time Drive::timeout() const {
  if (silence_ <= Duration{0} || last_command_ == Time::min()) return never;
  return last_command_ + silence_ + Duration{1};
}

Time Drive::next_change(Time now) const {
  const Time stop = timeout() > now ? timeout() : never;
  for (const Pending& pending : pending_) {
    if (pending.due > now) return std::min(pending.due, stop);
  }
  return stop;
}

WheelSpeeds Drive::step(Time now, double dt_s) {
  while (!pending_.empty() && pending_.front().due <= now) {
    target_ = pending_.front().target;
    pending_.pop_front();
  }
  if (timeout() <= now) {
    target_ = {};
    newest_.reset();
  }
  const double change = params_.acceleration_mps2 * dt_s;
  const double left_mps = approach(speeds_.left_mps, target_.left_mps, change);
  const double right_mps = approach(speeds_.right_mps, target_.right_mps, change);
  return {left_mps, right_mps};
}

void Drive::reset() {
  pending_.clear();
  newest_.reset();
  target_ = speeds_ = {};
  last_command_ = Time::min();
}

}  // namespace tocsin::kobuki
