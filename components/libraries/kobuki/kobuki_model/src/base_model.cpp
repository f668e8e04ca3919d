// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/base_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "foundation/error.hpp"
#include "geometry/pose.hpp"
#include "noise.hpp"

namespace tocsin::kobuki {
namespace {

constexpr auto frame_period = std::chrono::milliseconds(20);

Version parse_version(const char* name, const std::string& text, bool old_form) {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned patch = 0;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%3u.%3u.%3u%c", &major, &minor, &patch, &rest);
  if (read != 3 || major > 9 || minor > 99 || patch > 99) {
    throw ConfigError(std::string(name) + ": '" + text + "' is not a version like 1.2.0");
  }
  Version version{static_cast<std::uint8_t>(major), static_cast<std::uint8_t>(minor),
                  static_cast<std::uint8_t>(patch), std::nullopt};
  if (old_form) version.old_code = static_cast<std::uint16_t>(major * 100 + minor * 10 + patch);
  return version;
}

/// Factory firmware 1.0.0 says 123 in the old form.
Version parse_firmware(const std::string& text, bool old_form) {
  Version version = parse_version("firmware", text, old_form);
  if (version.old_code == 100) version.old_code = 123;
  return version;
}

}  // namespace

BaseModel::BaseModel(const ModelParams& params, Surroundings surroundings,
                     const geometry::Pose& start, std::uint64_t seed, Time now)
    : params_(params),
      hardware_(parse_version("hardware", params.hardware, params.old_versions)),
      firmware_(parse_firmware(params.firmware, params.old_versions)),
      random_(seed),
      drive_(params),
      body_(std::move(surroundings), start),
      power_(params),
      powered_on_(now),
      last_(now),
      next_frame_(now + frame_period) {
  for (std::uint32_t& word : unique_id_) word = static_cast<std::uint32_t>(random_());
  power_cycle(now);
}

bool BaseModel::set_versions(const std::string& hardware, const std::string& firmware,
                             bool old_form) {
  try {
    const Version new_hardware = parse_version("hardware", hardware, old_form);
    firmware_ = parse_firmware(firmware, old_form);
    hardware_ = new_hardware;
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

void BaseModel::power_cycle(Time now) {
  drive_.reset();
  reassembler_.clear();
  outputs_ = BaseOutputs{};
  asked_ = Answers{};
  velocity_ = {};
  left_ticks_ = static_cast<double>(random_() % 65536U);
  right_ticks_ = static_cast<double>(random_() % 65536U);
  gyro_rad_ = 0;
  powered_on_ = last_ = now;
  next_frame_ = now + frame_period;
}

double BaseModel::noise(double sigma) { return sigma <= 0 ? 0 : sigma * standard_normal(random_); }

void BaseModel::receive(ByteView bytes, Time now) {
  reassembler_.feed(bytes, [&](ByteView payload) {
    decode_commands(payload, command_counts_, [&](const Command& command) { obey(command, now); });
  });
}

void BaseModel::obey(const Command& command, Time now) {
  if (const auto* control = std::get_if<BaseControl>(&command)) {
    outputs_.control = *control;
    drive_.command(*control, now);
  }
  if (const auto* extra = std::get_if<RequestExtra>(&command)) request(*extra);
  if (const auto* outputs = std::get_if<OutputRegister>(&command)) outputs_.outputs = *outputs;
  if (const auto* tune = std::get_if<Tune>(&command)) {
    outputs_.last_tune = *tune;
    ++outputs_.sounds;
  }
  if (const auto* tone = std::get_if<Tone>(&command)) {
    outputs_.last_tone = *tone;
    ++outputs_.sounds;
  }
  if (!has_gains(firmware_)) return;
  if (const auto* set = std::get_if<SetGains>(&command)) outputs_.gains = set->gains;
  if (std::holds_alternative<GetGains>(command)) asked_.gains = true;
}

void BaseModel::request(const RequestExtra& request) {
  asked_.hardware |= (request.flags & RequestExtra::hardware) != 0;
  asked_.firmware |= (request.flags & RequestExtra::firmware) != 0;
  asked_.unique_id |= (request.flags & RequestExtra::unique_id) != 0;
}

void BaseModel::step(Time now, const FrameSink& sink) {
  while (last_ < now) {
    physics(std::min({now, next_frame_, last_ + body_.longest_move(), drive_.next_change(last_)}));
    if (last_ < next_frame_) continue;
    drift_gyro();
    const Frame frame = encode_feedback(sense(last_));
    sink(last_, frame.bytes());
    next_frame_ += frame_period;
    draw_slip();
  }
}

geometry::Twist BaseModel::true_velocity(const WheelSpeeds& rolling) const {
  const double grip = 1.0 - inputs_.slip;
  return body_velocity(
      {rolling.left_mps * params_.left_wheel_scale * (1.0 - left_slip_) * grip,
       rolling.right_mps * params_.right_wheel_scale * (1.0 - right_slip_) * grip});
}

void BaseModel::physics(Time now) {
  const double dt_s = to_seconds(now - last_);
  WheelSpeeds rolling = drive_.step(last_, dt_s);
  last_ = now;
  const geometry::Twist mean = body_.move(true_velocity(rolling), dt_s);
  if (body_.blocked()) {
    drive_.force(wheel_speeds({0, body_velocity(rolling).angular_rad_s}));
    rolling = drive_.speeds();
  }
  velocity_ = body_.blocked() ? mean : true_velocity(drive_.speeds());
  left_ticks_ += rolling.left_mps * dt_s / tick_m;
  right_ticks_ += rolling.right_mps * dt_s / tick_m;
  const double bias_rad = params_.gyro_bias_dps * dt_s * degree;
  gyro_rad_ =
      geometry::wrap_angle(gyro_rad_ + params_.gyro_scale * mean.angular_rad_s * dt_s + bias_rad);
  touch_dock();
  const WheelSpeeds& target = drive_.target();
  power_.step(dt_s, motor_current_a(rolling.left_mps, target.left_mps) +
                        motor_current_a(rolling.right_mps, target.right_mps));
}

void BaseModel::draw_slip() {
  left_slip_ = noise(params_.slip_sigma);
  right_slip_ = noise(params_.slip_sigma);
}

void BaseModel::drift_gyro() {
  const double root_of_period = std::sqrt(to_seconds(frame_period));
  const double drift_deg = noise(params_.gyro_drift_deg_per_sqrt_s) * root_of_period;
  gyro_rad_ = geometry::wrap_angle(gyro_rad_ + drift_deg * degree);
}

void BaseModel::touch_dock() {
  const bool docked = dock_ && dock_->in_contact(pose());
  if (docked == docked_) return;  // only the edges, so that a hand may plug the adapter
  docked_ = docked;
  power_.plug(docked ? ChargingSource::dock : ChargingSource::none);
}

double BaseModel::motor_current_a(double speed_mps, double target_mps) const {
  constexpr double running_a_per_mps = 0.8;
  constexpr double stalled_a_per_mps = 2.0;
  return running_a_per_mps * std::abs(speed_mps) +
         stalled_a_per_mps * std::abs(target_mps - speed_mps);
}

std::uint8_t BaseModel::bumper() const {
  return static_cast<std::uint8_t>(body_.bumper() | inputs_.bumper);
}

BaseMemory BaseModel::memory(Time now) const {
  return {pose(),         left_ticks_, right_ticks_, gyro_rad_, to_seconds(now - powered_on_),
          power_.charge()};
}

void BaseModel::recall(const BaseMemory& memory, Time now) {
  body_.place(memory.pose);
  left_ticks_ = memory.left_ticks;
  right_ticks_ = memory.right_ticks;
  gyro_rad_ = memory.gyro_rad;
  powered_on_ = now - seconds(memory.clock_s);
  power_.set_charge(memory.charge);
}

}  // namespace tocsin::kobuki
