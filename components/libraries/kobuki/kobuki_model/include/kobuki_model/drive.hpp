// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "foundation/time.hpp"
#include "kobuki_model/model_params.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::kobuki {

/// The wheel controllers: commands take effect after the dead time and within the acceleration
/// limit. Pure; `now` must not decrease.
class Drive {
 public:
  explicit Drive(const ModelParams& params)
      : params_(params), silence_(seconds(params.command_timeout_s)) {}
  void command(const BaseControl& control, Time now);
  /// From `now` on for `dt` > 0, exact if that does not go beyond `next_change(now)`. Returns the
  /// mean speeds, that is, how far the wheels rolled.
  WheelSpeeds step(Time now, double dt_s);
  /// When after `now` another target takes effect; `never` when none is known to.
  [[nodiscard]] Time next_change(Time now) const;
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
  /// When it stops itself; `never` without a timeout or a command.
  [[nodiscard]] Time timeout() const;
  ModelParams params_;
  Duration silence_;                   ///< after which it stops itself; 0 is never
  std::optional<BaseControl> newest_;  ///< of the commands that are still in force
  std::deque<Pending> pending_;
  WheelSpeeds target_;
  WheelSpeeds speeds_;
  Time last_command_ = Time::min();
};

}  // namespace tocsin::kobuki
