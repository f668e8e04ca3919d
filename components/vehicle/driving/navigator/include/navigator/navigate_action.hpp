// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/pose.hpp"
#include "navigator/navigator.hpp"
#include "navigator/pose_goal.hpp"
#include "runtime/action_port.hpp"
#include "tocsin_idl/actions.hpp"

namespace tocsin {

/// Offers the action navigate_to_pose to programs on the vehicle. Goals of the ground station come
/// first: none is accepted while one of them is driven to, and they end one of these.
class NavigateAction {
 public:
  /// `timeout_s`: so long a goal is driven to. `speed_mps`: for what is told of the time left.
  NavigateAction(Component& owner, double timeout_s, double speed_mps);

  /// The vehicle drives as fast as this from now on.
  void set_speed(double speed_mps) { speed_mps_ = speed_mps; }
  /// Takes goals and their cancellation to the navigator. True when it should be asked for a
  /// velocity at once.
  bool take(Navigator& navigator, Time now);
  /// Ends the goal when it is over.
  void follow(const Navigator::Output& output, Time now);
  /// Tells how the drive goes; `pose` of the vehicle, frame map, at `stamp`.
  void tell(const Navigator::Status& status, const geometry_msgs::msg::PoseStamped& pose, Time now);

 private:
  using Action = action::NavigateToPose;
  [[nodiscard]] const char* reason_to_reject(const Action::Goal& goal, const Navigator& navigator,
                                             Time now) const;
  void begin(const ActionServer<Action>::Asked& asked, Navigator& navigator, Time now);
  void finish(PoseGoalEnd end, Time now);
  struct Running {
    GoalId id;
    PoseGoal goal;
  };
  const double timeout_s_;
  double speed_mps_;
  ActionServer<Action> server_;
  Logger log_;
  std::optional<Running> running_;
};

}  // namespace tocsin
