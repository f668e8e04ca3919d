// SPDX-License-Identifier: Apache-2.0
#include "teleop/teleop_sender.hpp"

namespace tocsin {

bool TeleopSender::driving() const { return held_.linear_mps != 0 || held_.angular_rad_s != 0; }

void TeleopSender::hold(const geometry::Twist& velocity) {
  const bool same =
      velocity.linear_mps == held_.linear_mps && velocity.angular_rad_s == held_.angular_rad_s;
  if (same) return;
  held_ = velocity;
  changed_ = true;
  zeros_left_ = zeros;
}

std::optional<geometry::Twist> TeleopSender::update(Time now) {
  if (!changed_ && now < next_deadline()) return std::nullopt;
  if (!driving()) {
    if (zeros_left_ == 0) return std::nullopt;
    --zeros_left_;
  }
  changed_ = false;
  next_ = now + period_;
  return held_;
}

Time TeleopSender::next_deadline() const { return driving() || zeros_left_ > 0 ? next_ : never; }

}  // namespace tocsin
