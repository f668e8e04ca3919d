// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"

namespace tocsin {

/// Where the vehicle is on the map, from odometry and a known start.
///
/// Odometry that jumps farther than the vehicle can drive comes from a driver that was started
/// anew: the vehicle is then still where it was last, and odometry counts from there. What it can
/// have driven while no pose came counts for a second after that: poses may come in a burst.
class OdometryLocaliser {
 public:
  /// All that must be kept to go on after a restart of this process.
  struct Memory {
    geometry::Pose map_from_odom;
    geometry::Pose odom;  // the last pose in the odometry's own frame
  };

  /// `start` is the pose on the map [m, rad] at which odometry began to count.
  explicit OdometryLocaliser(const geometry::Pose& start) : memory_{start, {}} {}
  /// Goes on from what an earlier process remembered.
  explicit OdometryLocaliser(const Memory& memory) : memory_(memory), has_odom_(true) {}

  /// The pose on the map [m, rad]; empty when `odom` is not finite.
  [[nodiscard]] std::optional<geometry::Pose> update(const geometry::Pose& odom, Time now);
  [[nodiscard]] const Memory& memory() const { return memory_; }

 private:
  void note_gap(double moved_m, Time now);
  [[nodiscard]] bool has_restarted(const geometry::Pose& odom, Time now) const;

  Memory memory_;
  bool has_odom_ = false;
  std::optional<Time> last_;  // empty: nobody knows how long ago the last pose was
  double recent_gap_s_ = 0;   // without a pose lately, whose way has not come yet
  Time gap_ended_{};
};

}  // namespace tocsin
