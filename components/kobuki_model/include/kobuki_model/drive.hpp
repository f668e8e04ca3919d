// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "foundation/time.hpp"
#include "kobuki_model/model_params.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::kobuki {

/// The wheel controllers: commands take effect after the dead time and within the acceleration
/// limit. Pure; `now` must not decrease.
class Drive {
 public:
  explicit Drive(const ModelParams& params) : params_(params) {}
  void command(const BaseControl& control, Time now);
  /// Wheel speeds after `dt` more, at `now`.
  void step(Time now, double dt_s);
  /// Wheels at once as they are forced to be by an obstacle.
  void force(const WheelSpeeds& speeds) { speeds_ = speeds; }
  /// Power-on state: no command, standing still.
  void reset();

  [[nodiscard]] const WheelSpeeds& speeds() const { return speeds_; }
  [[nodiscard]] const WheelSpeeds& target() const { return target_; }

 private:
  struct Pending {
    Time due;
    WheelSpeeds target;
  };
  ModelParams params_;
  std::deque<Pending> pending_;
  WheelSpeeds target_;
  WheelSpeeds speeds_;
  Time last_command_ = Time::min();
};

}  // namespace tocsin::kobuki
