// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::kobuki {

struct VelocityParams {
  double cmd_vel_timeout_s = 0.6;
  double max_speed_mps = kobuki::max_speed_mps;
  double max_turn_rad_s = kobuki::max_turn_rate_rad_s;
  template <class Visitor>
  void visit(Visitor& v) {
    v("cmd_vel_timeout_s", cmd_vel_timeout_s, {0.05, 10}, "[s] an older command is a stop");
    v("max_speed_mps", max_speed_mps, {0.05, 0.7}, "[m/s] faster commands are scaled down");
    v("max_turn_rad_s", max_turn_rad_s, {0.1, 3.2}, "[rad/s] faster commands are scaled down");
  }
};

/// The velocity that the base shall have: the last command, until it is stale. Zero while held, as
/// by the emergency stop, whatever is commanded.
/// Pure; `now` must not decrease.
class VelocityHold {
 public:
  explicit VelocityHold(const VelocityParams& params)
      : params_(params), timeout_(seconds(params.cmd_vel_timeout_s)) {}
  /// A command beyond the limits is scaled as a whole, which keeps the radius. NaN or infinity in
  /// either part is a stop.
  void on_command(const geometry::Twist& velocity, Time now);
  /// Forgets the command: stop until the next one.
  void stop() { command_ = {}; }
  /// True: stop, and take no command until called with false; then stop until the next one.
  void hold(bool held);
  [[nodiscard]] bool is_held() const { return held_; }
  [[nodiscard]] geometry::Twist velocity(Time now) const;

 private:
  VelocityParams params_;
  Duration timeout_;
  geometry::Twist command_;
  Time received_ = Time::min();
  bool held_ = false;
};

}  // namespace tocsin::kobuki
