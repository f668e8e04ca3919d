// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_protocol/odometry.hpp"

namespace tocsin::kobuki {

inline CoreSensors core(int t_ms, int left, int right) {
  CoreSensors sensors;
  sensors.timestamp_ms = static_cast<std::uint16_t>(t_ms);
  sensors.left_encoder = static_cast<std::uint16_t>(left);
  sensors.right_encoder = static_cast<std::uint16_t>(right);
  return sensors;
}

inline Inertia inertia(int angle_cdeg, int rate = 0) {
  return {static_cast<std::int16_t>(angle_cdeg), static_cast<std::int16_t>(rate)};
}

inline OdometryParams by_encoder() {
  OdometryParams params;
  params.use_gyro_heading = false;
  return params;
}

}  // namespace tocsin::kobuki
