// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "mission_control/mission_action.hpp"
#include "mission_control/mission_control.hpp"
#include "runtime/action_port.hpp"
#include "tocsin_idl/actions.hpp"

namespace tocsin {

/// Offers the mission as the action follow_waypoints.
class WaypointsServer {
 public:
  WaypointsServer(Component& owner, MissionAction action);

  /// Takes goals and their cancellation to the mission.
  void take(MissionControl& control, Time now);
  /// Ends the goal when it is over.
  void follow(const MissionControl& control, Time now);
  /// Tells which pose is driven to.
  void tell(const MissionControl& control, Time now);

 private:
  using Action = action::FollowWaypoints;
  void begin(const ActionServer<Action>::Asked& asked, MissionControl& control, Time now);
  void finish(const WaypointsEnd& end, Time now);
  ActionServer<Action> server_;
  Logger log_;
  MissionAction action_;
  std::optional<ActionServer<Action>::Asked> running_;
};

}  // namespace tocsin
