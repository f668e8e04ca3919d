// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_model/walls.hpp"
#include "kobuki_protocol/feedback.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin::kobuki {

/// A charging dock: where its infrared light is seen, and when a base touches its contacts.
///
/// `pose` is the middle of the dock's front, the heading points away from it into the room. Left
/// and right are the dock's own, so that a base facing it from its left has the centre line on its
/// left hand. Angles and ranges are estimates: no public source gives the beams.
class Dock {
 public:
  explicit Dock(const Pose& pose) : pose_(pose) {}
  /// What the three receivers of a base see.
  [[nodiscard]] DockInfrared infrared(const Pose& base) const;
  /// Whether the contacts meet: the base faces the dock and touches it in the middle.
  [[nodiscard]] bool in_contact(const Pose& base) const;
  /// The front as a wall that stops a base.
  [[nodiscard]] Wall front() const;

 private:
  [[nodiscard]] unsigned beams_at(const Pose& base) const;
  Pose pose_;
};

}  // namespace tocsin::kobuki
