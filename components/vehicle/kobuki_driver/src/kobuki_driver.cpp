// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/kobuki_driver.hpp"

#include <algorithm>

namespace tocsin::kobuki {

KobukiDriver::KobukiDriver(const Params& params)
    : params_(params),
      offline_after_(seconds(params.offline_after_s)),
      velocity_(params.velocity),
      battery_(params.battery),
      odometry_(params.odometry),
      events_(params.battery) {}

void KobukiDriver::on_port_open() {
  reassembler_.clear();
  heard_ = false;
  state_ = BaseState::silent;
}

void KobukiDriver::on_port_lost() {
  velocity_.stop();
  waiting_.clear();
  state_ = BaseState::no_port;
}

void KobukiDriver::on_bytes(ByteView bytes, Time now, const ReadingSink& sink) {
  reassembler_.feed(bytes, [&](ByteView payload) { on_frame(payload, now, sink); });
}

Duration KobukiDriver::rest_of_frame() const {
  constexpr double byte_s = 10 / 115200.0;
  return seconds(static_cast<double>(reassembler_.lacking()) * byte_s);
}

void KobukiDriver::on_frame(ByteView payload, Time now, const ReadingSink& sink) {
  const Feedback feedback = decode_feedback(payload, decode_counts_);
  if (!feedback.core) return;  // not a frame of a base
  if (state_ == BaseState::silent) come_online(now);
  last_frame_ = now;
  inquiry_.on_feedback(feedback);
  check_firmware(feedback);
  reading_.feedback = feedback;
  read(now);
  sink(reading_);
  if (next_command_ - now <= command_period) next_command_ = now;
}

void KobukiDriver::come_online(Time now) {
  state_ = BaseState::online;
  inquiry_.begin(now);
  if (!heard_) next_command_ = now;
  heard_ = true;
  // A base that was switched off and on has its start value again.
  if (outputs_.bits != OutputRegister::start) waiting_.emplace_back(outputs_);
}

void KobukiDriver::check_firmware(const Feedback& feedback) {
  if (!feedback.firmware) return;
  const bool refused = judge_firmware(*feedback.firmware) == FirmwareSupport::refused;
  state_ = refused ? BaseState::refused : BaseState::online;
  if (refused) inquiry_.doubt_firmware();
}

void KobukiDriver::read(Time now) {
  const Feedback& feedback = reading_.feedback;
  const CoreSensors& core = *feedback.core;
  const bool first = odometry_time_ == Time::min();
  odometry_.update(core, feedback.inertia, first ? 0 : to_seconds(now - odometry_time_));
  if (!odometry_.waits()) odometry_time_ = now;
  reading_.battery = battery_.read(core.battery_dv, core.charger);
  reading_.pose = odometry_.pose();
  reading_.pose_is_old = odometry_.waits();
  reading_.linear_mps = odometry_.linear_mps();
  reading_.angular_rad_s = odometry_.angular_rad_s();
  reading_.gyro_heading_rad = odometry_.gyro_heading_rad();
  reading_.gyro_rate_rad_s = odometry_.gyro_rate_rad_s();
  reading_.left = odometry_.left();
  reading_.right = odometry_.right();
  reading_.events = events_.update(feedback);
}

void KobukiDriver::on_velocity(const geometry::Twist& velocity, Time now) {
  if (state_ == BaseState::online && motor_power_) velocity_.on_command(velocity, now);
}

void KobukiDriver::set_motor_power(bool on) {
  motor_power_ = on;
  velocity_.stop();
}

void KobukiDriver::on_emergency_stop(bool stands, Time now) {
  if (stands == emergency_stop()) return;
  velocity_.hold(stands);
  if (!stands) return;
  next_command_ = now;  // to stand
  waiting_.erase(
      std::remove_if(waiting_.begin(), waiting_.end(),
                     [](const Command& c) { return std::holds_alternative<SetGains>(c); }),
      waiting_.end());
}

void KobukiDriver::resume(const OdometrySnapshot& snapshot, Time odometry_time) {
  odometry_.restore(snapshot);
  odometry_time_ = odometry_time;
}

bool KobukiDriver::set_gains(const ControllerGains& gains) {
  const auto& firmware = inquiry_.firmware();
  if (emergency_stop() || !firmware || !has_gains(*firmware) || !send_once(SetGains{gains}))
    return false;
  inquiry_.forget_gains();
  return true;
}

void KobukiDriver::set_outputs(const OutputRegister& outputs) {
  outputs_ = outputs;
  // One waiting register is enough: the newest holds everything.
  waiting_.erase(
      std::remove_if(waiting_.begin(), waiting_.end(),
                     [](const Command& c) { return std::holds_alternative<OutputRegister>(c); }),
      waiting_.end());
  if (state_ == BaseState::online) waiting_.emplace_back(outputs_);
}

bool KobukiDriver::send_once(const Command& command) {
  if (state_ != BaseState::online || waiting_.size() >= max_waiting) return false;
  waiting_.push_back(command);
  return true;
}

void KobukiDriver::watch(Time now) {
  const bool heard_lately = now - last_frame_ <= offline_after_;
  if (state_ == BaseState::silent || heard_lately) return;
  state_ = BaseState::silent;
  next_command_ = now;  // stop at once
  velocity_.stop();
  waiting_.clear();
}

void KobukiDriver::run(Time now, const ByteSink& sink) {
  if (state_ == BaseState::no_port || !heard_) return;
  watch(now);
  if (now < next_command_) return;
  const bool is_answer = state_ == BaseState::online;
  next_command_ = now + (is_answer ? command_period * 3 / 2 : command_period);
  send_commands(now, sink);
}

void KobukiDriver::send_commands(Time now, const ByteSink& sink) {
  sink(encode_command(velocity_command(now)).bytes());
  if (state_ == BaseState::silent) return;
  if (state_ == BaseState::online) {
    for (const Command& command : waiting_) sink(encode_command(command).bytes());
    waiting_.clear();
  }
  if (const auto request = inquiry_.due(now)) sink(encode_command(*request).bytes());
}

BaseControl KobukiDriver::velocity_command(Time now) const {
  if (state_ != BaseState::online) return {};
  geometry::Twist velocity = velocity_.velocity(now);
  // The firmware computes wheel speeds with its nominal separation.
  velocity.angular_rad_s *= params_.odometry.wheel_separation_m / wheel_separation_m;
  return encode_velocity(velocity);
}

Time KobukiDriver::next_deadline() const {
  if (state_ == BaseState::no_port || !heard_) return never;
  if (state_ == BaseState::silent) return next_command_;
  return std::min(next_command_, last_frame_ + offline_after_ + Duration{1});
}

void KobukiDriver::farewell(const ByteSink& sink) const {
  if (state_ == BaseState::no_port || !heard_) return;
  for (int i = 0; i < 3; ++i) sink(encode_command(BaseControl{}).bytes());
}

}  // namespace tocsin::kobuki
