// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/twist.hpp"
#include "kobuki_protocol/command.hpp"

namespace tocsin::kobuki {

struct WheelSpeeds {
  double left_mps = 0;
  double right_mps = 0;
};

/// Speed and radius as the firmware wants them, rounded to the nearest and clamped to 16 bits last.
/// Turning on the spot is always radius +1 with a signed speed; radius -1 is never sent because its
/// reading by the firmware is unknown (reference page 1.5). NaN or infinity is a stop.
[[nodiscard]] BaseControl encode_velocity(const geometry::Twist& velocity);

/// What the firmware makes of a command.
[[nodiscard]] WheelSpeeds decode_velocity(const BaseControl& command);

[[nodiscard]] geometry::Twist body_velocity(const WheelSpeeds& wheels);
[[nodiscard]] WheelSpeeds wheel_speeds(const geometry::Twist& velocity);

}  // namespace tocsin::kobuki
