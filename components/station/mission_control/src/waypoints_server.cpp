// SPDX-License-Identifier: Apache-2.0
#include "mission_control/waypoints_server.hpp"
#include "geometry/pose_message.hpp"

#include <utility>

namespace tocsin {
namespace {

namespace code = nav2_msgs::action::FollowWaypoints_Result_Constants;

WaypointsGoal read(const action::FollowWaypoints::Goal& message) {
  WaypointsGoal goal;
  goal.loops = message.number_of_loops();
  goal.first = message.goal_index();
  for (const auto& stamped : message.poses()) {
    goal.poses.push_back({stamped.header().frame_id(), geometry::pose_in(stamped.pose())});
  }
  return goal;
}

}  // namespace

WaypointsServer::WaypointsServer(Component& owner, MissionAction action)
    : server_(owner), log_(owner.name(), owner.node()), action_(std::move(action)) {}

void WaypointsServer::take(MissionControl& control, Time now) {
  while (const auto asked = server_.take(now)) begin(*asked, control, now);
  if (!running_ || action_.is_canceling() || !server_.is_canceling(running_->id)) return;
  action_.cancel(control, now);
}

void WaypointsServer::begin(const ActionServer<Action>::Asked& asked, MissionControl& control,
                            Time now) {
  const std::string reason = action_.begin(read(*asked.goal), control);
  if (!reason.empty()) {
    log_.warn("a goal of {} is rejected: {}", Action::name, reason);
    Action::Result why;
    why.error_msg(reason);
    server_.reject(std::move(why));
    return;
  }
  server_.accept(now);
  log_.info("goal of {} with {} poses", Action::name, asked.goal->poses().size());
  if (running_) finish({WaypointsEnd::Kind::aborted, {}, "superseded by another goal"}, now);
  running_ = asked;
}

void WaypointsServer::follow(const MissionControl& control, Time now) {
  if (!running_) return;
  if (const auto end = action_.end(control, now)) finish(*end, now);
}

void WaypointsServer::finish(const WaypointsEnd& end, Time now) {
  const auto running = *std::exchange(running_, std::nullopt);
  Action::Result result;
  for (const std::uint32_t index : end.missed) {
    nav2_msgs::msg::MissedWaypoint missed;
    missed.index(index);
    missed.goal(running.goal->poses()[index]);
    missed.error_code(code::UNKNOWN);
    result.missed_waypoints().push_back(std::move(missed));
  }
  result.error_msg(end.reason);
  switch (end.kind) {
    case WaypointsEnd::Kind::succeeded:
      return server_.succeed(running.id, std::move(result), now);
    case WaypointsEnd::Kind::canceled:
      return server_.canceled(running.id, std::move(result), now);
    case WaypointsEnd::Kind::aborted:
      result.error_code(code::UNKNOWN);
      return server_.abort(running.id, std::move(result), now);
  }
}

void WaypointsServer::tell(const MissionControl& control, Time now) {
  if (!running_) return;
  Action::Feedback feedback;
  feedback.current_waypoint(action_.current(control, now));
  server_.feedback(running_->id, std::move(feedback));
}

}  // namespace tocsin
