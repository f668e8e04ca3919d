// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/dock.hpp"

#include <cmath>

#include "geometry/pose.hpp"
#include "kobuki_protocol/dimensions.hpp"

namespace tocsin::kobuki {
namespace {

using Light = DockInfrared;

constexpr double half_width_m = 0.12;
constexpr double contact_gap_m = 0.012;  // the contacts are springs

}  // namespace

/// The far field begins at the dock, so that both fields are seen in the near one.
unsigned Dock::beams_at(const Place& place) const {
  const double dx = place.x_m - pose_.x_m;
  const double dy = place.y_m - pose_.y_m;
  const double distance_m = std::hypot(dx, dy);
  const double angle = geometry::wrap_angle(std::atan2(dy, dx) - pose_.heading_rad);
  if (distance_m > light_.far_m || std::abs(angle) > light_.side_rad) return 0;
  const double aside_m = distance_m * std::sin(angle);  // to the dock's left
  unsigned beams = 0;
  if (std::abs(aside_m) <= light_.centre_half_width_m) beams |= Light::any_centre;
  if (aside_m >= -light_.overlap_m) beams |= Light::any_left;
  if (aside_m <= light_.overlap_m) beams |= Light::any_right;
  return distance_m <= light_.near_m ? beams : beams & ~Light::any_near;
}

std::uint8_t Dock::seen_by(const geometry::Pose& base, double receiver_rad, double view_rad) const {
  const double looks_rad = base.heading_rad + receiver_rad;
  const Place place{base.x_m + light_.rim_m * std::cos(looks_rad),
                    base.y_m + light_.rim_m * std::sin(looks_rad)};
  const double to_dock = std::atan2(pose_.y_m - place.y_m, pose_.x_m - place.x_m);
  if (std::abs(geometry::wrap_angle(to_dock - looks_rad)) > view_rad) return 0;
  return static_cast<std::uint8_t>(beams_at(place));
}

DockInfrared Dock::infrared(const geometry::Pose& base) const {
  return {seen_by(base, -light_.receiver_rad, light_.side_view_rad),
          seen_by(base, 0, light_.middle_view_rad),
          seen_by(base, light_.receiver_rad, light_.side_view_rad)};
}

bool Dock::in_contact(const geometry::Pose& base) const {
  const double dx = base.x_m - pose_.x_m;
  const double dy = base.y_m - pose_.y_m;
  const double ahead_m = dx * std::cos(pose_.heading_rad) + dy * std::sin(pose_.heading_rad);
  const double aside_m = -dx * std::sin(pose_.heading_rad) + dy * std::cos(pose_.heading_rad);
  const double turn = geometry::wrap_angle(base.heading_rad - pose_.heading_rad - pi);
  return ahead_m > 0 && ahead_m <= body_radius_m + contact_gap_m && std::abs(aside_m) < 0.05 &&
         std::abs(turn) < 25 * degree;
}

geometry::Wall Dock::front() const {
  const double dx = -std::sin(pose_.heading_rad) * half_width_m;
  const double dy = std::cos(pose_.heading_rad) * half_width_m;
  return {pose_.x_m - dx, pose_.y_m - dy, pose_.x_m + dx, pose_.y_m + dy, 0};
}

}  // namespace tocsin::kobuki
