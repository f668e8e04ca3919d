// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/beam_model.hpp"

namespace tocsin::localisation {

/// What was seen on the last two metres or so: a guess that comes late is asked whether it would
/// have seen the same.
class RecentScans {
 public:
  static constexpr double witnesses = 8;  ///< that the beams of a scan count for
  static constexpr double fading = 0.95;  ///< of evidence, each time some is counted

  /// The vehicle has made a step.
  void move(const geometry::Pose& step);
  void add(const laser::Scan& scan);
  void clear() { scans_.clear(); }
  [[nodiscard]] bool empty() const { return scans_.empty(); }

  /// How much likelier all of it is if the vehicle is at `pose` than if it is at `other`, or than
  /// certainty without one [logarithm]. It stops counting below `least`.
  [[nodiscard]] double advantage(const BeamModel& model, const geometry::Pose& pose,
                                 const std::optional<geometry::Pose>& other, double least) const;

 private:
  struct Seen {
    laser::Scan scan;
    geometry::Pose from_here;  ///< the vehicle's pose then, in its present frame
  };
  std::deque<Seen> scans_;  ///< newest first
};

}  // namespace tocsin::localisation
