// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/pose.hpp"

namespace tocsin::kobuki {
namespace {

// More than one short move at full speed (0.7 m/s * 5 ms), so that a stopped body always presses.
constexpr double bumper_travel_m = 0.005;
constexpr auto short_move = std::chrono::milliseconds(5);
constexpr auto long_move = std::chrono::milliseconds(20);
constexpr double longest_reach_m = body_radius_m + bumper_travel_m;
// Where no wall is within reach and this much more, none is asked for on so much way.
constexpr double clear_m = 0.2;
constexpr double long_move_m = 0.05;   // more than a long one at the limit of the wheels
constexpr double look_again_m = 0.05;  // near a wall

/// sin(turn / 2) / (turn / 2) for the small turn of a move: off by less than 1e-7 at 3.2 rad/s.
double chord_per_arc(double turn_rad) { return 1.0 - turn_rad * turn_rad / 24.0; }

}  // namespace

Body::Body(Surroundings surroundings, const geometry::Pose& start)
    : surroundings_(std::move(surroundings)), pose_(start) {}

bool Body::Look::is_over(double now_x_m, double now_y_m) const {
  const double dx_m = now_x_m - x_m;
  const double dy_m = now_y_m - y_m;
  const double valid_m = clear ? clear_m : look_again_m;
  return dx_m * dx_m + dy_m * dy_m >= valid_m * valid_m;
}

Duration Body::longest_move() const {
  const bool free = look_ && look_->clear && !look_->is_over(pose_.x_m, pose_.y_m);
  return free ? long_move : short_move;
}

bool Body::is_clear(double x_m, double y_m) const {
  if (!look_ || look_->is_over(x_m, y_m)) {
    const double radius_m = longest_reach_m + clear_m + long_move_m;
    look_ = Look{x_m, y_m, surroundings_(x_m, y_m, radius_m).empty()};
  }
  return look_->clear;
}

bool Body::goes_into(double x_m, double y_m, double direction_rad) const {
  if (is_clear(x_m, y_m)) return false;
  const auto touched = surroundings_(x_m, y_m, body_radius_m);
  return std::any_of(touched.begin(), touched.end(), [&](double bearing_rad) {
    return std::cos(bearing_rad - direction_rad) > 0;  // leaving an obstacle is always possible
  });
}

geometry::Twist Body::move(const geometry::Twist& wanted, double dt_s) {
  geometry::Twist real = wanted;
  const double heading = pose_.heading_rad + wanted.angular_rad_s * dt_s / 2.0;
  const double way_m = wanted.linear_mps * dt_s * chord_per_arc(wanted.angular_rad_s * dt_s);
  const double x_m = pose_.x_m + way_m * std::cos(heading);
  const double y_m = pose_.y_m + way_m * std::sin(heading);
  const double direction = wanted.linear_mps >= 0 ? heading : heading + pi;
  blocked_ = wanted.linear_mps != 0 && goes_into(x_m, y_m, direction);
  if (blocked_) {
    real.linear_mps = 0;
  } else {
    pose_.x_m = x_m;
    pose_.y_m = y_m;
  }
  pose_.heading_rad = geometry::wrap_angle(pose_.heading_rad + wanted.angular_rad_s * dt_s);
  return real;
}

std::uint8_t Body::bumper() const {
  if (is_clear(pose_.x_m, pose_.y_m)) return 0;
  unsigned bits = 0;
  for (const double bearing : surroundings_(pose_.x_m, pose_.y_m, longest_reach_m)) {
    bits |= bumper_bit(geometry::wrap_angle(bearing - pose_.heading_rad));
  }
  return static_cast<std::uint8_t>(bits);
}

std::uint8_t bumper_bit(double bearing_rad) {
  const double bearing_deg = bearing_rad / degree;
  if (std::abs(bearing_deg) > 90) return 0;
  if (std::abs(bearing_deg) <= 30) return centre_bit;
  return bearing_deg > 0 ? left_bit : right_bit;
}

}  // namespace tocsin::kobuki
