// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "scan_input/pose_history.hpp"

namespace tocsin {

/// Where the vehicle is on the map, by what a localiser says of a moment ago and by odometry since.
/// Pure; `now` must not decrease.
class LocaliserPose {
 public:
  explicit LocaliserPose(Duration timeout) : timeout_(timeout) {}

  /// `stamp_ns`: of the messages, since the Unix epoch. After a jump the localiser must speak anew.
  void on_odometry(std::int64_t stamp_ns, const geometry::Pose& odom);
  /// `deviation_m` of the pose: one that is not known to half a metre does not count, nor one that
  /// stays where it is while odometry says that the vehicle drives.
  void on_localiser(std::int64_t stamp_ns, const geometry::Pose& pose, double deviation_m,
                    Time now);
  /// Empty while the localiser is not sure, or silent for longer than its timeout.
  [[nodiscard]] std::optional<geometry::Pose> pose(Time now) const;

 private:
  [[nodiscard]] bool is_stuck(const geometry::Pose& pose, const geometry::Pose& odom, Time now);

  /// What localiser and odometry said together.
  struct Both {
    geometry::Pose pose;
    geometry::Pose odom;
  };
  Duration timeout_;
  PoseHistory odometry_;
  std::optional<geometry::Pose> odom_;
  geometry::Pose map_from_odom_;
  std::optional<Time> sure_;
  std::optional<Both> before_;  ///< where the vehicle was, half a metre of odometry ago at most
  Time stuck_until_{};
};

}  // namespace tocsin
