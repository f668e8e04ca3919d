// SPDX-License-Identifier: Apache-2.0
#include "navigator/navigate_action.hpp"

#include <cmath>
#include <cstring>
#include <utility>

#include "geometry/pose_message.hpp"

namespace tocsin {
namespace {

namespace code = nav2_msgs::action::NavigateToPose_Result_Constants;

std::uint64_t mission_of(const GoalId& id) {
  std::uint64_t mission = 0;
  std::memcpy(&mission, id.data(), sizeof mission);
  return mission;
}

builtin_interfaces::msg::Duration ros_duration(double s) {
  builtin_interfaces::msg::Duration duration;
  const double whole = std::floor(s);
  duration.sec(static_cast<std::int32_t>(whole));
  duration.nanosec(static_cast<std::uint32_t>((s - whole) * 1e9));
  return duration;
}

}  // namespace

NavigateAction::NavigateAction(Component& owner, double timeout_s, double speed_mps)
    : timeout_s_(timeout_s),
      speed_mps_(speed_mps),
      server_(owner),
      log_(owner.name(), owner.node()) {}

/// Null: it may be driven to.
const char* NavigateAction::reason_to_reject(const Action::Goal& goal, const Navigator& navigator,
                                             Time now) const {
  const std::string& frame = goal.pose().header().frame_id();
  if (frame != "map" && !frame.empty()) return "its frame is not map";
  if (!goal.behavior_tree().empty()) return "there are no behaviour trees here";
  if (!running_ && navigator.is_busy(now)) return "a goal of the ground station is driven to";
  return nullptr;
}

bool NavigateAction::take(Navigator& navigator, Time now) {
  bool any = false;
  while (const auto asked = server_.take(now)) {
    const char* const reason = reason_to_reject(*asked->goal, navigator, now);
    if (reason == nullptr) {
      begin(*asked, navigator, now);
      any = true;
    } else {
      log_.warn("a goal of {} is rejected: {}", Action::name, reason);
      Action::Result why;
      why.error_msg(reason);
      server_.reject(std::move(why));
    }
  }
  if (!running_ || running_->goal.is_canceling() || !server_.is_canceling(running_->id)) return any;
  running_->goal.cancel();
  navigator.drop_goal(now);
  return true;
}

void NavigateAction::begin(const ActionServer<Action>::Asked& asked, Navigator& navigator,
                           Time now) {
  Goal goal;
  goal.mission = mission_of(asked.id);
  goal.id = 1;
  goal.pose = {geometry::pose_in(asked.goal->pose().pose())};
  goal.expires = now + seconds(timeout_s_);
  const geometry::Pose to = goal.pose;
  const GoalAnswer answer = navigator.on_local_goal(std::move(goal), now);
  log_.info("goal of {} at ({:.2f}, {:.2f}): {}", Action::name, to.x_m, to.y_m, to_string(answer));
  if (answer != GoalAnswer::accepted) return;
  server_.accept(now);
  if (running_) finish(PoseGoalEnd::superseded, now);
  running_ = {asked.id, {mission_of(asked.id), now, now + seconds(timeout_s_)}};
}

void NavigateAction::follow(const Navigator::Output& output, Time now) {
  if (!running_) return;
  if (const auto end = running_->goal.end(output, now)) finish(*end, now);
}

void NavigateAction::finish(PoseGoalEnd end, Time now) {
  const GoalId id = running_->id;
  running_.reset();
  Action::Result result;
  if (end == PoseGoalEnd::reached) return server_.succeed(id, result, now);
  result.error_msg(to_string(end));
  if (end == PoseGoalEnd::canceled) return server_.canceled(id, result, now);
  result.error_code(code::UNKNOWN);
  server_.abort(id, result, now);
}

void NavigateAction::tell(const Navigator::Status& status,
                          const geometry_msgs::msg::PoseStamped& pose, Time now) {
  if (!running_) return;
  Action::Feedback feedback;
  feedback.current_pose(pose);
  feedback.navigation_time(ros_duration(to_seconds(now - running_->goal.started())));
  if (std::isfinite(status.distance_m)) {
    feedback.distance_remaining(static_cast<float>(status.distance_m));
    feedback.estimated_time_remaining(ros_duration(status.distance_m / speed_mps_));
  }
  server_.feedback(running_->id, std::move(feedback));
}

}  // namespace tocsin
