// SPDX-License-Identifier: Apache-2.0
#include "motion/auto_docking.hpp"

#include <cmath>

#include "kobuki_protocol/geometry.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin::motion {
namespace {

constexpr unsigned near_left = 1;
constexpr unsigned near_centre = 2;
constexpr unsigned near_right = 4;
constexpr unsigned far_centre = 8;
constexpr unsigned far_left = 16;
constexpr unsigned far_right = 32;
constexpr unsigned near_any = near_left | near_centre | near_right;
constexpr unsigned far_any = far_left | far_centre | far_right;
constexpr unsigned any_left = near_left | far_left;
constexpr unsigned any_centre = near_centre | far_centre;
constexpr unsigned any_right = near_right | far_right;

constexpr double near_turn_rad_s = 0.1;
constexpr double far_turn_rad_s = 0.3;
constexpr double back_off_mps = -0.05;
constexpr double release_mps = -0.01;

/// -1, 0 or 1: which side of the centre line a group of three bits says; 0 also for all three.
int side_of(unsigned bits, unsigned left, unsigned right) {
  const bool l = (bits & left) != 0;
  const bool r = (bits & right) != 0;
  if (l == r) return 0;
  return l ? -1 : 1;
}

}  // namespace

const char* to_string(DockingState state) {
  switch (state) {
    case DockingState::idle:
      return "idle";
    case DockingState::scan:
      return "scan";
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
  started_ = last_light_ = last_input_ = now;
  enter(DockingState::scan);
}

void AutoDocking::cancel() {
  if (running()) finish(DockingResult::cancelled);
}

void AutoDocking::finish(DockingResult result) {
  result_ = result;
  state_ = DockingState::done;
}

void AutoDocking::enter(DockingState state) {
  state_ = state;
  if (state != DockingState::scan) return;
  detector_ = 0;
  turned_rad_ = 0;
}

bool AutoDocking::watch(Time now) {
  if (!running() || now - last_input_ <= seconds(params_.silence_s)) return false;
  finish(DockingResult::sensors_lost);
  return true;
}

BodyVelocity AutoDocking::update(const DockingInput& input, Time now) {
  if (!running()) return {};
  last_input_ = now;
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
    if (charging_for_ >= charged_updates) finish(DockingResult::docked);
    return true;
  }
  charging_for_ = 0;
  if (input.bumper != 0) {
    state_ = DockingState::bumped;
    backed_off_ = now + seconds(params_.back_off_s);
    return true;
  }
  return false;
}

void AutoDocking::decide(const DockingInput& input, Time now) {
  switch (state_) {
    case DockingState::scan:
      return scan(input.heading_rad);
    case DockingState::find_stream:
      return find_stream();
    case DockingState::get_stream:
      return get_stream();
    case DockingState::aligned_far:
    case DockingState::aligned_near:
      return align();
    case DockingState::bumped:
      if (now >= backed_off_) enter(DockingState::scan);
      return;
    case DockingState::bumped_dock:
    case DockingState::docked_in:  // the charger was lost: look again
      return enter(DockingState::scan);
    case DockingState::idle:
    case DockingState::done:
      return;
  }
}

void AutoDocking::scan(double heading_rad) {
  if (has_heading_) turned_rad_ += std::abs(kobuki::wrap_angle(heading_rad - last_heading_rad_));
  last_heading_rad_ = heading_rad;
  has_heading_ = true;
  if ((seen_.centre & any_centre) != 0) return align();
  if ((seen_.centre & any_left) != 0) --detector_;
  if ((seen_.centre & any_right) != 0) ++detector_;
  if (turned_rad_ <= 2 * kobuki::pi) return;
  // A whole turn without light from any side: another turn, not a drive into the blue.
  enter(detector_ == 0 ? DockingState::scan : DockingState::find_stream);
}

void AutoDocking::find_stream() {
  const bool across = detector_ > 0 ? (seen_.left & any_right) != 0 : (seen_.right & any_left) != 0;
  if (across) enter(DockingState::get_stream);
}

void AutoDocking::get_stream() {
  const bool crossed =
      detector_ > 0 ? (seen_.left & any_left) != 0 : (seen_.right & any_right) != 0;
  if (crossed) enter(DockingState::scan);
}

void AutoDocking::align() {
  if ((seen_.centre & near_any) != 0) {
    enter(DockingState::aligned_near);
  } else if ((seen_.centre & far_any) != 0) {
    enter(DockingState::aligned_far);
  } else {
    enter(DockingState::scan);
  }
}

/// `beside` is where the base is: -1 left of the centre line, 1 right. Askew means that another
/// receiver sees the dock too. Askew away from the line it turns on the spot, and the reference
/// drives on; askew towards the line it goes straight.
BodyVelocity AutoDocking::steer(double speed_mps, int beside, double turn_rad_s) const {
  const int askew = (seen_.right != 0 ? 1 : 0) - (seen_.left != 0 ? 1 : 0);
  if (askew == 0) return {speed_mps, -beside * turn_rad_s};
  if (askew == -beside) return {speed_mps, 0};
  return {0, -askew * params_.find_turn_rad_s};
}

BodyVelocity AutoDocking::aligned_velocity() const {
  if (state_ == DockingState::aligned_near) {
    return steer(params_.near_mps, side_of(seen_.centre, near_left, near_right), near_turn_rad_s);
  }
  return steer(params_.far_mps, side_of(seen_.centre, far_left, far_right), far_turn_rad_s);
}

BodyVelocity AutoDocking::velocity() const {
  switch (state_) {
    case DockingState::scan:
      return {0, params_.scan_turn_rad_s};
    case DockingState::find_stream:
      return {0, detector_ > 0 ? -params_.find_turn_rad_s : params_.find_turn_rad_s};
    case DockingState::get_stream:
      return {params_.near_mps, 0};
    case DockingState::aligned_far:
    case DockingState::aligned_near:
      return aligned_velocity();
    case DockingState::bumped:
      return {back_off_mps, 0};
    case DockingState::bumped_dock:
      return {release_mps, 0};
    default:
      return {};
  }
}

}  // namespace tocsin::motion
