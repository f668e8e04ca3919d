// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/time.hpp"
#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {

/// Turn rates in the axes of the robot: x forward, y left, z up.
struct AngularVelocity {
  double x_rad_s = 0;
  double y_rad_s = 0;
  double z_rad_s = 0;
};

/// The chip is mounted turned by 90 degrees counter-clockwise (reference page 1.3, ID 13).
[[nodiscard]] inline AngularVelocity angular_velocity(const RawGyro::Sample& sample) {
  return {-sample.y * gyro_digit_rad_s, sample.x * gyro_digit_rad_s, sample.z * gyro_digit_rad_s};
}

/// When sample `index` of `count` was taken, if the frame arrived at `arrival`: 10 ms apart.
[[nodiscard]] inline Time gyro_sample_time(Time arrival, int index, int count) {
  return arrival - std::chrono::milliseconds(10) * (count - 1 - index);
}

}  // namespace tocsin::kobuki
