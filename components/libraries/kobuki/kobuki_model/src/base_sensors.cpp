// SPDX-License-Identifier: Apache-2.0
/// What the simulated base reports in a frame.
#include <algorithm>
#include <cmath>

#include "kobuki_model/base_model.hpp"

namespace tocsin::kobuki {
namespace {

std::uint16_t wrapped_ticks(double ticks) {
  return static_cast<std::uint16_t>(static_cast<std::int64_t>(std::floor(ticks)) & 0xFFFF);
}

/// To the nearest; halves away from 0.
int rounded(double value) { return static_cast<int>(value + std::copysign(0.5, value)); }

std::int8_t pwm_of(double speed_mps) {
  const double percent = 100.0 * speed_mps / max_speed_mps;
  return static_cast<std::int8_t>(rounded(std::clamp(percent, -100.0, 100.0)));
}

std::int16_t to_i16(double value) {
  return static_cast<std::int16_t>(rounded(std::clamp(value, -32768.0, 32767.0)));
}

std::uint8_t current_byte(double current_a) {  // 10 mA units
  return static_cast<std::uint8_t>(rounded(std::clamp(100.0 * current_a, 0.0, 255.0)));
}

}  // namespace

Feedback BaseModel::sense(Time now) {
  Feedback feedback;
  feedback.core = core_sensors(now);
  disturb_encoders(*feedback.core);
  feedback.dock_infrared = dock_infrared();
  feedback.inertia = inertia();
  feedback.cliff_adc = cliff_adc();
  const WheelSpeeds speeds = drive_.speeds();
  const WheelSpeeds target = drive_.target();
  feedback.current =
      MotorCurrent{current_byte(motor_current_a(speeds.left_mps, target.left_mps)),
                   current_byte(motor_current_a(speeds.right_mps, target.right_mps))};
  feedback.gyro = raw_gyro();
  feedback.input = general_input();
  answer(feedback);
  return feedback;
}

void BaseModel::disturb_encoders(CoreSensors& core) {
  if (params_.encoder_noise_ticks <= 0) return;
  for (std::uint16_t* encoder : {&core.left_encoder, &core.right_encoder}) {
    const auto off = std::lround(noise(params_.encoder_noise_ticks));
    *encoder = static_cast<std::uint16_t>(*encoder + off);
  }
}

CoreSensors BaseModel::core_sensors(Time now) const {
  CoreSensors core;
  const auto since_ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(now - powered_on_).count();
  core.timestamp_ms = static_cast<std::uint16_t>(since_ms & 0xFFFF);
  core.bumper = bumper();
  core.wheel_drop = inputs_.wheel_drop;
  core.cliff = inputs_.cliff;
  core.left_encoder = wrapped_ticks(left_ticks_);
  core.right_encoder = wrapped_ticks(right_ticks_);
  core.left_pwm = pwm_of(drive_.target().left_mps);
  core.right_pwm = pwm_of(drive_.target().right_mps);
  core.buttons = inputs_.buttons;
  core.charger = power_.charger();
  core.battery_dv = power_.battery_dv();
  core.over_current = inputs_.over_current;
  return core;
}

Inertia BaseModel::inertia() {
  const double rate_dps = params_.gyro_scale * velocity_.angular_rad_s / degree +
                          params_.gyro_bias_dps + noise(params_.gyro_noise_dps);
  return {to_i16(gyro_rad_ / centidegree_rad), to_i16(100.0 * rate_dps)};
}

RawGyro BaseModel::raw_gyro() {
  const double digit_dps = gyro_digit_rad_s / degree;
  const double rate_dps =
      params_.gyro_scale * velocity_.angular_rad_s / degree + params_.gyro_bias_dps;
  RawGyro gyro;
  gyro.count = 2;
  gyro.frame_id = gyro_frame_id_;
  gyro_frame_id_ = static_cast<std::uint8_t>(gyro_frame_id_ + gyro.count);
  for (std::size_t i = 0; i < gyro.count; ++i) {
    gyro.samples[i].x = to_i16(noise(params_.gyro_noise_dps) / digit_dps);
    gyro.samples[i].y = to_i16(noise(params_.gyro_noise_dps) / digit_dps);
    gyro.samples[i].z = to_i16((rate_dps + noise(params_.gyro_noise_dps)) / digit_dps);
  }
  return gyro;
}

CliffAdc BaseModel::cliff_adc() const {
  constexpr std::uint16_t floor_adc = 1800;  // real captures: 1600 to 2050 on floor
  constexpr std::uint16_t cliff_value = 300;
  const auto adc = [&](std::uint8_t bit) {
    return (inputs_.cliff & bit) ? cliff_value : floor_adc;
  };
  return {adc(right_bit), adc(centre_bit), adc(left_bit)};
}

void BaseModel::miss_signals(DockInfrared& seen) {
  if (params_.infrared_loss <= 0) return;
  std::bernoulli_distribution missed(params_.infrared_loss);
  for (std::uint8_t* receiver : {&seen.right, &seen.centre, &seen.left}) {
    for (unsigned signal = 1; signal <= DockInfrared::far_right; signal *= 2) {
      if (missed(random_)) *receiver = static_cast<std::uint8_t>(*receiver & ~signal);
    }
  }
}

DockInfrared BaseModel::dock_infrared() {
  DockInfrared seen = dock_ ? dock_->infrared(pose()) : DockInfrared{};
  miss_signals(seen);
  seen.right = static_cast<std::uint8_t>(seen.right | inputs_.dock.right);
  seen.centre = static_cast<std::uint8_t>(seen.centre | inputs_.dock.centre);
  seen.left = static_cast<std::uint8_t>(seen.left | inputs_.dock.left);
  return seen;
}

GeneralInput BaseModel::general_input() const {
  GeneralInput input;
  input.digital = inputs_.digital;
  input.analog = inputs_.analog;
  input.unused = {0x0FF0, 0, 0};
  return input;
}

void BaseModel::answer(Feedback& feedback) {
  if (asked_.hardware) feedback.hardware = hardware_;
  if (asked_.firmware) feedback.firmware = firmware_;
  if (asked_.unique_id) feedback.unique_id = unique_id_;
  if (asked_.gains) feedback.gains = outputs_.gains;
  asked_ = Answers{};
}

}  // namespace tocsin::kobuki
