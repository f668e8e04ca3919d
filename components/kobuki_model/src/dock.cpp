// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/dock.hpp"

#include <cmath>

#include "kobuki_protocol/geometry.hpp"

namespace tocsin::kobuki {
namespace {

constexpr double near_m = 0.7;  // from the front of the dock to the middle of the base
constexpr double far_m = 3.0;
constexpr double centre_rad = 10 * degree_rad;         // half the centre beam
constexpr double inner_rad = 4 * degree_rad;           // inner edge of the side beams
constexpr double side_rad = 55 * degree_rad;           // outer edge of the side beams
constexpr double receiver_rad = 60 * degree_rad;       // between receivers
constexpr double receiver_view_rad = 40 * degree_rad;  // half the view of a receiver
constexpr double half_width_m = 0.12;
constexpr double contact_gap_m = 0.012;  // the contacts are springs

std::uint8_t if_seen(unsigned beams, double bearing_rad, double receiver) {
  const bool seen = std::abs(wrap_angle(bearing_rad - receiver)) <= receiver_view_rad;
  return static_cast<std::uint8_t>(seen ? beams : 0);
}

}  // namespace

unsigned Dock::beams_at(const Pose& base) const {
  const double dx = base.x_m - pose_.x_m;
  const double dy = base.y_m - pose_.y_m;
  const double distance_m = std::hypot(dx, dy);
  const double angle = wrap_angle(std::atan2(dy, dx) - pose_.heading_rad);
  if (distance_m > far_m || std::abs(angle) > side_rad) return 0;
  const bool close = distance_m <= near_m;
  unsigned beams = 0;
  if (std::abs(angle) <= centre_rad) beams |= close ? 2U : 8U;
  if (angle >= inner_rad) beams |= close ? 1U : 16U;
  if (angle <= -inner_rad) beams |= close ? 4U : 32U;
  return beams;
}

DockInfrared Dock::infrared(const Pose& base) const {
  const unsigned beams = beams_at(base);
  const double to_dock = std::atan2(pose_.y_m - base.y_m, pose_.x_m - base.x_m);
  const double bearing = wrap_angle(to_dock - base.heading_rad);
  return {if_seen(beams, bearing, -receiver_rad), if_seen(beams, bearing, 0),
          if_seen(beams, bearing, receiver_rad)};
}

bool Dock::in_contact(const Pose& base) const {
  const double dx = base.x_m - pose_.x_m;
  const double dy = base.y_m - pose_.y_m;
  const double ahead_m = dx * std::cos(pose_.heading_rad) + dy * std::sin(pose_.heading_rad);
  const double aside_m = -dx * std::sin(pose_.heading_rad) + dy * std::cos(pose_.heading_rad);
  const double turn = wrap_angle(base.heading_rad - pose_.heading_rad - pi);
  return ahead_m > 0 && ahead_m <= body_radius_m + contact_gap_m && std::abs(aside_m) < 0.05 &&
         std::abs(turn) < 25 * degree_rad;
}

Wall Dock::front() const {
  const double dx = -std::sin(pose_.heading_rad) * half_width_m;
  const double dy = std::cos(pose_.heading_rad) * half_width_m;
  return {pose_.x_m - dx, pose_.y_m - dy, pose_.x_m + dx, pose_.y_m + dy, 0};
}

}  // namespace tocsin::kobuki
