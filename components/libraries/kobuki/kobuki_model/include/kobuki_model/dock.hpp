// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/pose.hpp"
#include "geometry/wall.hpp"
#include "kobuki_model/surroundings.hpp"
#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/feedback.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin::kobuki {

/// Where the light of a dock goes, and where a base's receivers look. README.md tells which of
/// these are published and which are estimates.
struct DockLight {
  double far_m = 5.0;
  double near_m = 2.4;
  double centre_half_width_m = 0.055;    ///< of the centre beam, the same at every distance
  double overlap_m = 0.03;               ///< of a side beam over the centre line
  double side_rad = 55 * degree;         ///< outer edge of the side beams, from the axis
  double rim_m = 0.16;                   ///< of the receivers from the middle of the base
  double receiver_rad = 60 * degree;     ///< between receivers
  double middle_view_rad = 40 * degree;  ///< half the view of the middle receiver
  double side_view_rad = 40 * degree;    ///< half the view of the others
};

/// A charging dock: where its infrared light is seen, and when a base touches its contacts.
///
/// `pose` is the middle of the dock's front, the heading points away from it into the room. Left
/// and right are the dock's own, so that a base facing it from its left has the centre line on its
/// left hand. Pure.
class Dock {
 public:
  explicit Dock(const geometry::Pose& pose, const DockLight& light = {})
      : pose_(pose), light_(light) {}
  /// What the three receivers of a base see.
  [[nodiscard]] DockInfrared infrared(const geometry::Pose& base) const;
  /// Whether the contacts meet: the base faces the dock and touches it in the middle.
  [[nodiscard]] bool in_contact(const geometry::Pose& base) const;
  /// The front as a wall that stops a base.
  [[nodiscard]] geometry::Wall front() const;

 private:
  struct Place {
    double x_m;
    double y_m;
  };
  [[nodiscard]] std::uint8_t seen_by(const geometry::Pose& base, double receiver_rad,
                                     double view_rad) const;
  [[nodiscard]] unsigned beams_at(const Place& place) const;
  geometry::Pose pose_;
  DockLight light_;
};

}  // namespace tocsin::kobuki
