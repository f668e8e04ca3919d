// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_protocol/command.hpp"

namespace tocsin::kobuki {

/// Motion of the base's centre: forwards, and counter-clockwise seen from above.
struct BodyVelocity {
  double linear_mps = 0;
  double angular_rad_s = 0;
};

struct WheelSpeeds {
  double left_mps = 0;
  double right_mps = 0;
};

/// Speed and radius as the firmware wants them, rounded to the nearest and clamped to 16 bits last.
/// Turning on the spot is always radius +1 with a signed speed; radius -1 is never sent because its
/// reading by the firmware is unknown (reference page 1.5). NaN or infinity is a stop.
[[nodiscard]] BaseControl encode_velocity(const BodyVelocity& velocity);

/// What the firmware makes of a command.
[[nodiscard]] WheelSpeeds decode_velocity(const BaseControl& command);

[[nodiscard]] BodyVelocity body_velocity(const WheelSpeeds& wheels);
[[nodiscard]] WheelSpeeds wheel_speeds(const BodyVelocity& velocity);

}  // namespace tocsin::kobuki
