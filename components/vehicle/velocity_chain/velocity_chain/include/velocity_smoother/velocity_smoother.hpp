// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/twist.hpp"

namespace tocsin {

/// Limits speed and acceleration so that the base follows the commanded radius.
///
/// A command beyond a speed limit is scaled as a whole. Each step moves towards it along the
/// straight line in (v, w), as far as both acceleration limits allow. A source that falls silent
/// for three of its periods (at least 0.2, at most 0.5 s) is a command to stop, reached with the
/// deceleration limits. Pure; `now` must not decrease.
class VelocitySmoother {
 public:
  struct Params {
    double speed_lim_v_mps = 0.8;
    double speed_lim_w_rad_s = 5.4;
    double accel_lim_v_mps2 = 0.3;
    double accel_lim_w_rad_s2 = 3.5;
    double decel_factor = 1.0;
    double frequency_hz = 20;
    double repeat_s = 0.25;
    template <class Visitor>
    void visit(Visitor& v) {
      live(v)("speed_lim_v_mps", speed_lim_v_mps, {0.01, 2}, "[m/s] greatest speed");
      live(v)("speed_lim_w_rad_s", speed_lim_w_rad_s, {0.01, 10}, "[rad/s] greatest turn rate");
      live(v)("accel_lim_v_mps2", accel_lim_v_mps2, {0.01, 10}, "[m/s2] greatest acceleration");
      live(v)("accel_lim_w_rad_s2", accel_lim_w_rad_s2, {0.01, 50},
              "[rad/s2] greatest turn acceleration");
      live(v)("decel_factor", decel_factor, {0.1, 10}, "[1] deceleration over acceleration limits");
      v("frequency_hz", frequency_hz, {5, 100}, "[Hz] of output while the velocity changes");
      v("repeat_s", repeat_s, {0.05, 0.5}, "[s] between outputs of a velocity that stays");
    }
  };

  explicit VelocitySmoother(const Params& params) : params_(params) {}
  /// Other limits from now on, for what is driven already, too.
  void set_limits(const Params& params);
  /// NaN or infinity in either part is a stop.
  void on_command(const geometry::Twist& velocity, Time now);
  /// The velocity to send now, if one is due; call after each command and at `next_deadline`.
  [[nodiscard]] std::optional<geometry::Twist> update(Time now);
  /// `never` at rest.
  [[nodiscard]] Time next_deadline(Time now) const;
  /// The velocity for the next period; call at `frequency_hz`, or `update` in its place.
  [[nodiscard]] geometry::Twist step(Time now);
  /// Whether nothing moves and nothing is wanted: the output may fall silent.
  [[nodiscard]] bool at_rest(Time now) const;

 private:
  static constexpr std::size_t window = 5;
  static constexpr double longest_silence_s = 0.5;
  [[nodiscard]] bool silent(Time now) const;
  /// Of the commands of late: a longer one means that they have stopped.
  [[nodiscard]] double usual_silence_s() const;
  /// Within the speed limits, scaled as a whole.
  [[nodiscard]] geometry::Twist fitted(const geometry::Twist& velocity) const;
  [[nodiscard]] geometry::Twist wanted(Time now) const;
  [[nodiscard]] bool settled(Time now) const;

  Params params_;
  geometry::Twist target_;
  geometry::Twist current_;
  std::array<double, window> periods_s_{};
  std::size_t heard_ = 0;
  double timeout_s_ = longest_silence_s;
  Time last_command_ = Time::min();
  Time next_step_ = Time::min();
  Time next_repeat_ = Time::min();
};

}  // namespace tocsin
