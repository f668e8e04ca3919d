// SPDX-License-Identifier: Apache-2.0
#include "rplidar_driver/rplidar_driver.hpp"

#include <algorithm>

namespace tocsin::rplidar {
namespace {

constexpr Duration quiet_time = std::chrono::milliseconds(50);  ///< after a stop: old readings
constexpr Duration answer_time = std::chrono::milliseconds(500);
constexpr double longest_pause_s = 10;

}  // namespace

const char* to_text(LaserState state) {
  switch (state) {
    case LaserState::no_port:
      return "the port is closed";
    case LaserState::asking:
      return "asked who it is";
    case LaserState::unhealthy:
      return "it reports an error of its own";
    case LaserState::starting:
      return "starting";
    case LaserState::scanning:
      return "scanning";
    case LaserState::silent:
      return "it sends nothing that an RPLIDAR sends at this baud rate";
    case LaserState::stalled:
      break;
  }
  return "it does not turn";
}

void RplidarDriver::enter(Phase phase, Time deadline) {
  phase_ = phase;
  deadline_ = deadline;
  has_answered_ = false;
}

void RplidarDriver::on_port_open(Time now) {
  state_ = LaserState::asking;
  pause_s_ = 1;
  info_.reset();
  health_.reset();
  enter(Phase::boot, now);  // begins with the next run
}

void RplidarDriver::on_port_lost() {
  state_ = LaserState::no_port;
  turn_hz_ = 0;
  turns_.clear();
  decoder_.clear();
  enter(Phase::closed, never);
}

std::vector<Bytes> RplidarDriver::farewell() { return {request(Command::stop), motor_request(0)}; }

void RplidarDriver::run(Time now, const ByteSink& sink) {
  const bool awaits_answer = phase_ == Phase::info || phase_ == Phase::health;
  if (awaits_answer && has_answered_) return go_on(now, sink);
  if (now < deadline_) return;
  switch (phase_) {
    case Phase::closed:
      return;
    case Phase::boot:
      sink(request(Command::stop));
      return enter(Phase::quiet, now + quiet_time);
    case Phase::quiet:
      decoder_.clear();
      sink(request(Command::get_info));
      return enter(Phase::info, now + answer_time);
    case Phase::info:
    case Phase::health:
      return fail(LaserState::silent, now, sink);
    case Phase::scan:
      return fail(has_answered_ ? LaserState::stalled : LaserState::silent, now, sink);
  }
}

/// After an answer.
void RplidarDriver::go_on(Time now, const ByteSink& sink) {
  if (phase_ == Phase::info) {
    sink(request(Command::get_health));
    return enter(Phase::health, now + answer_time);
  }
  if (health_->status == Health::Status::error) return fail(LaserState::unhealthy, now, sink);
  begin_scan(now, sink);
}

void RplidarDriver::begin_scan(Time now, const ByteSink& sink) {
  if (params_.motor_duty > 0) {
    sink(motor_request(static_cast<std::uint16_t>(params_.motor_duty)));
  }
  sink(request(params_.express ? Command::express_scan : Command::scan));
  turns_.clear();
  turn_readings_ = 0;
  if (state_ == LaserState::asking) state_ = LaserState::starting;
  // A rotor needs a second or two to its speed, and a turn more.
  enter(Phase::scan, now + seconds(2 + params_.turn_timeout_s));
}

void RplidarDriver::fail(LaserState why, Time now, const ByteSink& sink) {
  state_ = why;
  turn_hz_ = 0;
  turns_.clear();
  sink(request(Command::reset));
  enter(Phase::boot, now + seconds(pause_s_));
  pause_s_ = std::min(2 * pause_s_, longest_pause_s);
}

void RplidarDriver::take(const Answer& answer, Time, std::vector<Reading>& readings) {
  if (const auto* reading = std::get_if<Reading>(&answer)) {
    if (phase_ == Phase::scan) readings.push_back(*reading);
  } else if (std::holds_alternative<ScanBegins>(answer)) {
    has_answered_ |= phase_ == Phase::scan;
  } else if (const auto* info = std::get_if<Info>(&answer)) {
    info_ = *info;
    has_answered_ |= phase_ == Phase::info;
  } else if (const auto* health = std::get_if<Health>(&answer)) {
    health_ = *health;
    has_answered_ |= phase_ == Phase::health;
  }
}

void RplidarDriver::on_bytes(ByteView bytes, Time now, const TurnSink& sink) {
  if (phase_ == Phase::closed || phase_ == Phase::quiet || phase_ == Phase::boot) return;
  std::vector<Reading> readings;
  decoder_.feed(bytes, [&](const Answer& answer) { take(answer, now, readings); });
  take_readings(readings, now, sink);
}

/// Readings come in packets: the last one was made just now, the others before it.
void RplidarDriver::take_readings(const std::vector<Reading>& readings, Time now,
                                  const TurnSink& sink) {
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto later = static_cast<double>(readings.size() - 1 - i);
    ++turn_readings_;
    const auto turn = turns_.on_reading(readings[i], now - seconds(later * reading_s_));
    if (turn) on_turn(*turn, now, sink);
  }
}

void RplidarDriver::on_turn(const Turn& turn, Time now, const TurnSink& sink) {
  reading_s_ = turn.period_s / std::max(1, turn_readings_);
  turn_readings_ = 0;
  turn_hz_ = 1 / turn.period_s;
  state_ = LaserState::scanning;
  pause_s_ = 1;
  deadline_ = now + seconds(params_.turn_timeout_s);
  sink(turn);
}

}  // namespace tocsin::rplidar
