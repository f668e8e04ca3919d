// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/velocity_hold.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::kobuki {

void VelocityHold::on_command(const geometry::Twist& velocity, Time now) {
  if (held_) return;
  received_ = now;
  command_ = {};
  if (!std::isfinite(velocity.linear_mps) || !std::isfinite(velocity.angular_rad_s)) return;
  const double excess = std::max({1.0, std::abs(velocity.linear_mps) / params_.max_speed_mps,
                                  std::abs(velocity.angular_rad_s) / params_.max_turn_rad_s});
  command_ = {velocity.linear_mps / excess, velocity.angular_rad_s / excess};
}

void VelocityHold::hold(bool held) {
  held_ = held;
  stop();
}

geometry::Twist VelocityHold::velocity(Time now) const {
  if (held_ || received_ == Time::min() || now - received_ > timeout_) return {};
  return command_;
}

}  // namespace tocsin::kobuki
