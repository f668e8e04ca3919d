// SPDX-License-Identifier: Apache-2.0
#include "auto_docking/auto_docking.hpp"

#include <algorithm>
#include <cmath>

#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin {
namespace {

using Light = DockInfrared;

constexpr double crossing_rad = 60 * degree;  // between the bearing and the way across
constexpr double lean_rad = 15 * degree;      // towards the centre line
constexpr double turned_rad = 2 * degree;     // near enough
constexpr double turn_gain_hz = 2;            // damped: times a dead time of 0.2 s, 0.4
constexpr Duration blind_drive = std::chrono::seconds(2);  // 0.2 m
constexpr double hold_turn_rad_s = 0.3;
constexpr double least_turn_rad_s = 0.1;  // a slower turn may stick
constexpr double back_off_mps = -0.05;
constexpr double release_mps = -0.01;

/// Of one receiver's signals: which side of the centre line they tell of.
DockSide side_of(unsigned signals, unsigned left, unsigned right) {
  const bool l = (signals & left) != 0;
  const bool r = (signals & right) != 0;
  if (l == r) return DockSide::centre;
  return l ? DockSide::left : DockSide::right;
}

/// Of a whole sweep: any centre signal is enough to drive in.
DockSide side_of_sweep(unsigned signals) {
  if ((signals & Light::any_centre) != 0) return DockSide::centre;
  return side_of(signals, Light::any_left, Light::any_right);
}

Turn towards_dock(DockSide side) { return side == DockSide::left ? Turn::right : Turn::left; }

}  // namespace

const char* to_string(DockingState state) {
  switch (state) {
    case DockingState::idle:
      return "idle";
    case DockingState::scan:
      return "scan";
    case DockingState::face:
      return "face";
    case DockingState::find_stream:
      return "find_stream";
    case DockingState::get_stream:
      return "get_stream";
    case DockingState::aligned_far:
      return "aligned_far";
    case DockingState::aligned_near:
      return "aligned_near";
    case DockingState::bumped:
      return "bumped";
    case DockingState::bumped_dock:
      return "bumped_dock";
    case DockingState::docked_in:
      return "docked_in";
    case DockingState::done:
      break;
  }
  return "done";
}

const char* to_string(DockingResult result) {
  switch (result) {
    case DockingResult::none:
      return "none";
    case DockingResult::docked:
      return "docked";
    case DockingResult::no_dock_found:
      return "no_dock_found";
    case DockingResult::timeout:
      return "timeout";
    case DockingResult::cancelled:
      return "cancelled";
    case DockingResult::sensors_lost:
      break;
  }
  return "sensors_lost";
}

void AutoDocking::start(Time now) {
  *this = AutoDocking(params_);
  started_ = last_light_ = now;
  begin_scan(Turn::left);
}

void AutoDocking::cancel() {
  if (running()) finish(DockingResult::cancelled);
}

void AutoDocking::finish(DockingResult result) {
  result_ = result;
  state_ = DockingState::done;
}

void AutoDocking::begin_scan(Turn turn) {
  state_ = DockingState::scan;
  sweep_ = LightSweep(turn);
}

bool AutoDocking::watch(Time now) {
  const Time patient_until =
      last_input_ ? *last_input_ + seconds(params_.silence_s) : started_ + seconds(params_.start_s);
  if (!running() || now <= patient_until) return false;
  finish(DockingResult::sensors_lost);
  return true;
}

geometry::Twist AutoDocking::update(const DockingInput& input, Time now) {
  if (!running()) return {};
  last_input_ = now;
  heading_rad_ = input.heading_rad;
  remember(input.infrared);
  if ((seen_.left | seen_.centre | seen_.right) != 0) last_light_ = now;
  if (!handle_contact(input, now) && check_limits(now)) decide(input, now);
  return velocity();
}

void AutoDocking::remember(const DockInfrared& infrared) {
  past_[past_at_++ % window] = infrared;
  unsigned left = 0;
  unsigned centre = 0;
  unsigned right = 0;
  for (const DockInfrared& one : past_) {
    left |= one.left;
    centre |= one.centre;
    right |= one.right;
  }
  seen_ = {static_cast<std::uint8_t>(right), static_cast<std::uint8_t>(centre),
           static_cast<std::uint8_t>(left)};
}

/// False when docking has ended.
bool AutoDocking::check_limits(Time now) {
  if (now - started_ > seconds(params_.timeout_s)) finish(DockingResult::timeout);
  if (now - last_light_ > seconds(params_.search_s)) finish(DockingResult::no_dock_found);
  return running();
}

/// True when charger or bumper decide alone.
bool AutoDocking::handle_contact(const DockingInput& input, Time now) {
  if (input.charger != 0) {
    const bool pressed = input.bumper != 0;
    state_ = pressed ? DockingState::bumped_dock : DockingState::docked_in;
    charging_for_ = pressed ? 0 : charging_for_ + 1;
    target_rad_ = input.heading_rad;
    if (charging_for_ >= charged_updates) finish(DockingResult::docked);
    return true;
  }
  charging_for_ = 0;
  if (input.bumper != 0 || contact_is_marginal()) {
    back_off(now);
    return true;
  }
  return false;
}

/// The contacts have just met and parted, and not for the first time: from here they will not last.
bool AutoDocking::contact_is_marginal() {
  const bool in_dock = state_ == DockingState::bumped_dock || state_ == DockingState::docked_in;
  return in_dock && ++contacts_lost_ >= most_contacts_lost;
}

void AutoDocking::back_off(Time now) {
  state_ = DockingState::bumped;
  backed_off_ = now + seconds(params_.back_off_s);
  contacts_lost_ = 0;
}

void AutoDocking::decide(const DockingInput& input, Time now) {
  switch (state_) {
    case DockingState::scan:
      return scan(input);
    case DockingState::face:
    case DockingState::find_stream:
      return turn_to_target();
    case DockingState::get_stream:
      return get_stream(now);
    case DockingState::aligned_far:
    case DockingState::aligned_near:
      return align();
    case DockingState::bumped:
      if (now >= backed_off_) begin_scan(Turn::left);
      return;
    case DockingState::bumped_dock:
    case DockingState::docked_in:  // the charger was lost: on, as it stands
      return align();
    case DockingState::idle:
    case DockingState::done:
      return;
  }
}

void AutoDocking::scan(const DockingInput& input) {
  sweep_.update(input.heading_rad, input.infrared.centre);
  if (!sweep_.complete()) return;
  side_ = side_of_sweep(sweep_.signals());
  state_ = side_ == DockSide::centre ? DockingState::face : DockingState::find_stream;
  target_rad_ = geometry::wrap_angle(sweep_.bearing_rad() - static_cast<int>(side_) * crossing_rad);
}

void AutoDocking::turn_to_target() {
  if (std::abs(geometry::wrap_angle(target_rad_ - heading_rad_)) > turned_rad) return;
  if (state_ == DockingState::find_stream) {
    state_ = DockingState::get_stream;
  } else {
    align();
  }
}

/// Across the centre line until its light or that of the other side comes. Without light it would
/// leave the field: then it looks for the dock from where it is, nearer to the line than before.
void AutoDocking::get_stream(Time now) {
  const unsigned signals = seen_.left | seen_.centre | seen_.right;
  const bool crossed = signals != 0 && side_of(signals, Light::any_left, Light::any_right) != side_;
  if (crossed || now - last_light_ > blind_drive) begin_scan(towards_dock(side_));
}

void AutoDocking::align() {
  if ((seen_.centre & Light::any_near) != 0) {
    state_ = DockingState::aligned_near;
  } else if ((seen_.centre & Light::any_far) != 0) {
    state_ = DockingState::aligned_far;
  } else {
    begin_scan(seen_.right != 0 ? Turn::right : Turn::left);
  }
}

double AutoDocking::hold(double target_rad, double limit_rad_s) const {
  const double error_rad = geometry::wrap_angle(target_rad - heading_rad_);
  return std::clamp(turn_gain_hz * error_rad, -limit_rad_s, limit_rad_s);
}

geometry::Twist AutoDocking::aligned_velocity(double speed_mps, unsigned signals) const {
  const DockSide side = (signals & Light::any_near) != 0
                            ? side_of(signals, Light::near_left, Light::near_right)
                            : side_of(signals, Light::far_left, Light::far_right);
  return {speed_mps, hold(target_rad_ - static_cast<int>(side) * lean_rad, hold_turn_rad_s)};
}

geometry::Twist AutoDocking::velocity() const {
  switch (state_) {
    case DockingState::scan: {
      const double rate = params_.scan_turn_rad_s;
      return {0, sweep_.turn() == Turn::left ? rate : -rate};
    }
    case DockingState::face:
    case DockingState::find_stream: {
      const double rate = hold(target_rad_, params_.find_turn_rad_s);
      return {0, std::copysign(std::max(std::abs(rate), least_turn_rad_s), rate)};
    }
    case DockingState::get_stream:
      return {params_.far_mps, hold(target_rad_, hold_turn_rad_s)};
    case DockingState::aligned_far:
      return aligned_velocity(params_.far_mps, seen_.centre);
    case DockingState::aligned_near:
      return aligned_velocity(params_.near_mps, seen_.centre);
    case DockingState::bumped:
      return {back_off_mps, 0};
    case DockingState::bumped_dock:
      return {release_mps, 0};
    default:
      return {};
  }
}

}  // namespace tocsin
