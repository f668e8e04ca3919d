// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "mission_control/mission_control.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin {

/// What a goal of FollowWaypoints asks for.
struct WaypointsGoal {
  struct Place {
    std::string frame;
    geometry::Pose pose;
  };
  std::vector<Place> poses;
  std::uint32_t loops = 0;  ///< after the first
  std::uint32_t first = 0;  ///< index of the pose to begin with; later loops begin with 0
};

/// How one has ended.
struct WaypointsEnd {
  enum class Kind : std::uint8_t { succeeded, aborted, canceled };
  Kind kind;
  std::vector<std::uint32_t> missed;  ///< indices of its poses, in the order of the drive
  std::string reason;                 ///< empty: succeeded
};

/// The mission as goals of nav2's action FollowWaypoints: which of them can be driven to, and what
/// becomes of the one that is.
///
/// Pure. As in nav2 a goal takes the place of the one before, and of a mission from a file. It is
/// reached when its last pose is; a pose that an operator has skipped is missed, and one that is
/// blocked or not reached in its time is missed and ends the goal.
class MissionAction {
 public:
  /// `map`: that poses are checked against, for a robot of that radius; nothing: unchecked.
  explicit MissionAction(std::optional<navigation::OccupancyMap> map = {},
                         double robot_radius_m = 0);

  /// Has `control` lead through it. What hinders that, as one line; empty: nothing.
  [[nodiscard]] std::string begin(const WaypointsGoal& goal, MissionControl& control);
  /// Has the vehicle stop.
  void cancel(MissionControl& control, Time now);
  [[nodiscard]] bool is_canceling() const { return is_canceling_; }
  /// Index of the pose that is driven to.
  [[nodiscard]] std::uint32_t current(const MissionControl& control, Time now) const;
  /// How it has ended. One that is canceled ends when the vehicle is known to halt.
  [[nodiscard]] std::optional<WaypointsEnd> end(const MissionControl& control, Time now) const;

 private:
  [[nodiscard]] std::uint32_t index_of(std::uint32_t waypoint) const;
  [[nodiscard]] std::vector<std::uint32_t> missed(const MissionControl& control, Time now) const;

  std::optional<navigation::OccupancyMap> map_;
  double robot_radius_m_;
  std::uint32_t poses_ = 1;  // of the goal
  std::uint32_t first_ = 0;
  bool is_canceling_ = false;
};

}  // namespace tocsin
