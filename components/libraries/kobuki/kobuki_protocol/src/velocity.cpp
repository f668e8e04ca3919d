// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/velocity.hpp"

#include <algorithm>
#include <cmath>

#include "kobuki_protocol/dimensions.hpp"

namespace tocsin::kobuki {
namespace {

constexpr double epsilon = 1e-4;  // reference page 1.5
constexpr double half_separation_mm = 500.0 * wheel_separation_m;

std::int16_t to_i16(double value) {
  return static_cast<std::int16_t>(std::clamp(std::round(value), -32768.0, 32767.0));
}

}  // namespace

BaseControl encode_velocity(const geometry::Twist& velocity) {
  const double v = velocity.linear_mps;
  const double w = velocity.angular_rad_s;
  if (!std::isfinite(v) || !std::isfinite(w)) return {};
  if (std::abs(w) < epsilon) return {to_i16(1000.0 * v), 0};
  const double radius = 1000.0 * v / w;
  const double side = radius > 0 ? half_separation_mm : -half_separation_mm;
  if (std::abs(v) < epsilon || std::abs(std::round(radius)) <= 1.0) {
    return {to_i16(half_separation_mm * w), 1};
  }
  return {to_i16((radius + side) * w), to_i16(radius)};
}

WheelSpeeds decode_velocity(const BaseControl& command) {
  const double speed = command.speed_mm_s / 1000.0;
  const int radius = command.radius_mm;
  if (radius == 0) return {speed, speed};
  if (std::abs(radius) == 1) return {-radius * speed, radius * speed};
  const double size = std::abs(radius);
  const double inner = speed * (size - half_separation_mm) / (size + half_separation_mm);
  return radius > 0 ? WheelSpeeds{inner, speed} : WheelSpeeds{speed, inner};
}

geometry::Twist body_velocity(const WheelSpeeds& wheels) {
  return {(wheels.left_mps + wheels.right_mps) / 2.0,
          (wheels.right_mps - wheels.left_mps) / wheel_separation_m};
}

WheelSpeeds wheel_speeds(const geometry::Twist& velocity) {
  const double half = velocity.angular_rad_s * wheel_separation_m / 2.0;
  return {velocity.linear_mps - half, velocity.linear_mps + half};
}

}  // namespace tocsin::kobuki
