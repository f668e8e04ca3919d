// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/rplidar_model.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin::rplidar {
namespace {

constexpr Duration packet_period = std::chrono::milliseconds(20);
constexpr Duration boot_time = std::chrono::milliseconds(500);
constexpr std::string_view greeting = "RP LIDAR System.\r\nFirmware Ver 1.29, HW Ver 7\r\n";

}  // namespace

RplidarModel::RplidarModel(const ModelParams& params, Eye eye, Time now)
    : params_(params), eye_(std::move(eye)) {
  if (!params_.motor_by_request) start_motor(true, now);
}

void RplidarModel::receive(ByteView bytes, Time now) {
  if (boots_at_ && now < *boots_at_) return;
  requests_.add(bytes);
  while (const auto request = requests_.next()) obey(*request, now);
}

void RplidarModel::obey(const Request& request, Time now) {
  if (request.command == Command::set_motor_pwm) {
    if (params_.motor_by_request) start_motor(request.motor_duty > 0, now);
    return;
  }
  scan_.reset();
  const auto answer = [this](AnswerType type, const Bytes& bytes) {
    const Bytes head = descriptor(type);
    waiting_.insert(waiting_.end(), head.begin(), head.end());
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  };
  switch (request.command) {
    case Command::get_info:
      return answer(AnswerType::info, encode(Info{params_.model, 1, 29, 7, {}}));
    case Command::get_health:
      return answer(AnswerType::health, encode(health_));
    case Command::scan:
      return begin_scan(AnswerType::scan, now);
    case Command::express_scan:
      return begin_scan(AnswerType::express, now);
    case Command::reset:
      waiting_.clear();
      boots_at_ = now + boot_time;
      return;
    case Command::stop:
    case Command::set_motor_pwm:
      return;
  }
}

void RplidarModel::begin_scan(AnswerType type, Time now) {
  if (health_.status == Health::Status::error) return;
  const Bytes head = descriptor(type);
  waiting_.insert(waiting_.end(), head.begin(), head.end());
  scan_ = Scan{type, now + packet_period, now};
  scan_->before_rad = whole_turn(angle_at(now));
}

void RplidarModel::start_motor(bool on, Time now) {
  if (!on) {
    full_speed_at_.reset();
  } else if (!full_speed_at_) {
    full_speed_at_ = now + seconds(params_.spin_up_s);
  }
}

void RplidarModel::stall(bool held, Time now) {
  is_held_ = held;
  if (!held && full_speed_at_) full_speed_at_ = now + seconds(params_.spin_up_s);
}

bool RplidarModel::is_turning(Time now) const {
  return full_speed_at_ && !is_held_ && now >= *full_speed_at_;
}

double RplidarModel::angle_at(Time at) const {
  return 2 * pi * params_.turn_hz * to_seconds(at.time_since_epoch());
}

bool RplidarModel::is_in_view(double clockwise_rad) const {
  return params_.view_rad >= 2 * pi ||
         whole_turn(-clockwise_rad - params_.first_rad) <= params_.view_rad;
}

Time RplidarModel::next_event() const {
  if (!waiting_.empty()) return Time::min();
  Time next = Time::max();
  if (boots_at_) next = *boots_at_;
  if (scan_) next = std::min(next, scan_->next);
  return next;
}

void RplidarModel::step(Time now, const Sink& sink) {
  if (boots_at_ && now >= *boots_at_) {
    boots_at_.reset();
    waiting_.insert(waiting_.end(), greeting.begin(), greeting.end());
  }
  if (!waiting_.empty()) {
    const Bytes bytes = std::exchange(waiting_, {});
    sink({bytes.data(), bytes.size()});
  }
  if (scan_ && now >= scan_->next) sample(now, sink);
}

void RplidarModel::sample(Time until, const Sink& sink) {
  const Time from = scan_->sampled;
  Time done = until;
  Bytes bytes;
  if (is_turning(from)) {
    bytes = scan_->type == AnswerType::scan ? plain_readings(from, until, done)
                                            : capsules(from, until, done);
  }
  scan_->sampled = done;
  scan_->next = until + packet_period;
  if (!bytes.empty()) sink({bytes.data(), bytes.size()});
}

Reading RplidarModel::reading_at(Time at) const {
  const double angle_rad = whole_turn(angle_at(at));
  const double bearing_rad = std::remainder(-angle_rad, 2 * pi);
  const Look look = eye_(bearing_rad, at);
  const bool has_return = std::isfinite(look.range_m) && look.range_m > 0;
  return {angle_rad, has_return ? look.range_m : 0, has_return ? look.quality : 0, false};
}

Bytes RplidarModel::plain_readings(Time from, Time until, Time& done) {
  const Duration step = seconds(1 / params_.readings_per_s);
  Bytes bytes;
  const auto count = (until - from) / step;
  done = from + count * step;
  for (std::int64_t i = 0; i < count; ++i) {
    const Time at = from + i * step;
    const double angle_rad = whole_turn(angle_at(at));
    const bool begins = angle_rad < scan_->before_rad;
    scan_->before_rad = angle_rad;
    Reading reading = is_in_view(angle_rad) ? reading_at(at) : Reading{angle_rad, 0, 0, false};
    reading.begins_turn = begins;
    const Bytes one = encode(reading);
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  return bytes;
}

Bytes RplidarModel::capsules(Time from, Time until, Time& done) {
  const Duration step = seconds(0.5 / params_.readings_per_s);
  Bytes bytes;
  for (done = from; done + capsule_readings * step <= until; done += capsule_readings * step) {
    std::array<double, capsule_readings> ranges_m{};
    for (std::size_t i = 0; i < capsule_readings; ++i) {
      const Time at = done + static_cast<std::int64_t>(i) * step;
      if (is_in_view(angle_at(at))) ranges_m[i] = reading_at(at).range_m;
    }
    const Bytes one = encode_capsule(angle_at(done), ranges_m, scan_->is_first);
    scan_->is_first = false;
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  return bytes;
}

}  // namespace tocsin::rplidar
