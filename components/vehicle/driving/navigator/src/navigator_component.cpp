// SPDX-License-Identifier: Apache-2.0
#include "navigator/navigator_component.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "foundation/role.hpp"
#include "geometry/pose_message.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {

namespace {

using navigation::Cell;

constexpr Duration map_period = std::chrono::seconds(1);

Navigator make_navigator(const NavigatorComponent::Params& params) {
  if (params.map_file.empty()) {
    // Nothing is known until a map comes.
    return {params.navigator, navigation::OccupancyMap({1, 1, 0.05, {}}, {Cell::unknown})};
  }
  return {params.navigator, navigation::load_map(params.map_file),
          navigation::load_costs(params.map_file, params.navigator.inflation)};
}

OdometryLocaliser make_localiser(const LocaliserFile& file, const geometry::Pose& start) {
  const auto memory = file.load();
  return memory ? OdometryLocaliser(*memory) : OdometryLocaliser(start);
}

}  // namespace

NavigatorComponent::NavigatorComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      navigator_(make_navigator(params)),
      action_(*this, params.pose_goal_timeout_s, params.navigator.follower.speed_mps),
      file_(context.state_path(".pose")),
      goal_file_(context.state_path(".goal")),
      localiser_(make_localiser(file_, {params.start_x_m, params.start_y_m, params.start_yaw_rad})),
      localiser_pose_(seconds(params.localiser_timeout_s)) {
  if (params.map_file.empty()) map_.emplace(*this, WakeMode::time_triggered);
  if (params.localisation == PoseSource::localiser)
    amcl_pose_.emplace(*this, WakeMode::time_triggered);
  if (params.navigator.surroundings.avoid_obstacles) {
    obstacles_.emplace(*this);
    costmaps_.emplace(*this);
  }
  if (params.navigator.heeds_link()) link_.emplace(*this);
  go_on_with_earlier_goal(context.bus.now());
}

void NavigatorComponent::set_parameters(const Params& params) {
  params_ = params;
  navigator_.set_live(params.navigator);
  action_.set_speed(params.navigator.follower.speed_mps);
}

void NavigatorComponent::tick(Time now) {
  take_map(now);
  take_odometry(now);
  take_localiser(now);
  if (obstacles_) obstacles_->take(navigator_, now);
  if (costmaps_) costmaps_->take(navigator_);
  if (link_) link_->take(navigator_);
  take_store(now);
  const bool is_ordered = take_orders(now);
  report_location(now);
  if (is_turn(now) || is_ordered) {
    const Navigator::Output output = navigator_.update(now);
    drive(output.velocity);
    action_.follow(output, now);
    latest_ = output.status;
    report_status(output.status, now);
    report_plan(now);
  }
  remember(now);
  wake_at(std::min(next_turn_, emergency_stop_.deadline()));
}

/// Costs of a whole map take a while.
void NavigatorComponent::take_map(Time now) {
  if (!map_) return;
  has_new_map_ = map_->take() || has_new_map_;
  if (!has_new_map_ || now < next_map_) return;
  has_new_map_ = false;
  next_map_ = now + map_period;
  navigator_.set_map(*map_->map());
}

/// Whether a velocity is due: it need not follow each of fifty poses a second.
bool NavigatorComponent::is_turn(Time now) {
  if (now < next_turn_) return false;
  next_turn_ = next_instant(seconds(1 / params_.rate_hz), now);
  return true;
}

void NavigatorComponent::take_odometry(Time now) {
  const auto odom = odom_.take_latest();
  if (!odom) return;
  const std::int64_t stamp_ns = stamp_ns_of(odom->header());
  pose_ = pose_by(geometry::pose_in(odom->pose().pose()), stamp_ns, now);
  if (!pose_) return;
  navigator_.on_pose(*pose_, now);
  if (!obstacles_) return;
  const auto& twist = odom->twist().twist();
  obstacles_->on_pose(stamp_ns, *pose_, {twist.linear().x(), twist.angular().z()});
}

std::optional<geometry::Pose> NavigatorComponent::pose_by(const geometry::Pose& odom,
                                                          std::int64_t stamp_ns, Time now) {
  if (!amcl_pose_) return localiser_.update(odom, now);
  localiser_pose_.on_odometry(stamp_ns, odom);
  return localiser_pose_.pose(now);
}

void NavigatorComponent::take_localiser(Time now) {
  if (!amcl_pose_) return;
  const auto message = amcl_pose_->take_latest();
  if (!message) return;
  const auto& covariance = message->pose().covariance();
  covariance_ = covariance;
  constexpr std::size_t y = 7;  // of six rows and columns
  localiser_pose_.on_localiser(stamp_ns_of(message->header()),
                               geometry::pose_in(message->pose().pose()),
                               std::sqrt(covariance[0] + covariance[y]), now);
}

/// Both hosts tell the state of their routers.
void NavigatorComponent::take_store(Time now) {
  while (const auto state = link_state_.take()) {
    if (role_of(state->role()) != context().role) continue;
    StoreBacklog store;
    for (const auto& topic : state->stored()) {
      store.waiting += topic.waiting();
      store.backfilled += topic.backfilled();
    }
    navigator_.on_store(store, now);
  }
}

/// True when there was one to answer at once.
bool NavigatorComponent::take_orders(Time now) {
  bool any = false;
  if (emergency_stop_.take(now)) {
    navigator_.on_emergency_stop(emergency_stop_.stands());
    any = true;
  }
  while (const auto heartbeat = heartbeat_.take()) {
    if (role_of(heartbeat->role()) == Role::gcs) navigator_.on_ground_station(now);
  }
  while (const auto goal = goal_.take()) {
    take_goal(*goal, now);
    any = true;
  }
  return action_.take(navigator_, now) || any;
}

void NavigatorComponent::take_goal(const topic::Goal::Message& message, Time now) {
  // Counted from its arrival: the clocks of both sides may differ by hours. How old it may have
  // become on its way is limited by the lifespan of its topic.
  const Duration lifetime = seconds(std::clamp(message.lifetime_s(), 0.0, 3600.0));
  Goal goal{message.mission(),
            message.id(),
            {{message.x(), message.y(), message.yaw()}, message.send_s()},
            message.tolerance_m(),
            now + lifetime,
            {}};
  for (const auto& place : message.ahead()) {
    goal.ahead.push_back({{place.x(), place.y(), place.yaw()}, place.send_s()});
  }
  const auto answer = navigator_.on_goal(std::move(goal), now);
  if (answer == GoalAnswer::accepted) mission_ = message.mission();
  if (answer == GoalAnswer::renewed) return;
  log().info("goal {} of mission {:x} to waypoint {} at ({:.2f}, {:.2f}): {}", message.id(),
             message.mission(), message.waypoint(), message.x(), message.y(), to_string(answer));
}

void NavigatorComponent::drive(const geometry::Twist& velocity) {
  const bool stands = velocity.linear_mps == 0 && velocity.angular_rad_s == 0;
  if (stands && is_standing_) return;
  topic::CmdVelNavigation::Message message;
  message.linear().x(velocity.linear_mps);
  message.angular().z(velocity.angular_rad_s);
  is_standing_ = cmd_vel_.write(std::move(message)) == Status::ok && stands;
}

void NavigatorComponent::report_location(Time now) {
  if (!pose_ || now < next_location_) return;
  next_location_ = next_instant(seconds(1 / params_.location_hz), now);
  topic::Location::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id("map");
  message.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(*pose_));
  message.pose().covariance(covariance_);
  geometry_msgs::msg::PoseStamped at;
  at.header(message.header());
  at.pose(message.pose().pose());
  action_.tell(latest_, at, now);
  if (location_.write(std::move(message)) == Status::failed) log().warn("a location was not sent");
}

void NavigatorComponent::report_status(const Navigator::Status& status, Time now) {
  const bool stands = status.state != Navigator::State::driving;
  const bool has_changed = status.state != reported_.state || status.goal_id != reported_.goal_id ||
                           status.mission != reported_.mission ||
                           (stands && std::string_view(status.reason) != reported_.reason);
  if (!has_changed && now < next_status_) return;
  topic::NavigationStatus::Message message;
  message.stamp(wall(now));
  message.goal_id(status.goal_id);
  message.mission(status.mission);
  message.state(to_string(status.state));
  message.distance_m(status.distance_m);
  message.reason(status.reason);
  if (status_.write(std::move(message)) == Status::failed) return;
  if (has_changed) log_change(status);
  reported_ = status;
  next_status_ = next_instant(seconds(params_.status_period_s), now);
}

void NavigatorComponent::report_plan(Time now) {
  if (costmaps_) costmaps_->report(navigator_.surroundings(), pose_, wall(now), now);
  if (link_) link_->report(navigator_, params_.navigator.follower.speed_mps, wall(now));
  if (navigator_.plans() == plans_ || !plan_.wanted()) return;
  plans_ = navigator_.plans();
  topic::Plan::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id("map");
  for (const geometry::Point& corner : navigator_.path()) {
    geometry_msgs::msg::PoseStamped stamped;
    stamped.header(message.header());
    stamped.pose(geometry::pose_message<geometry_msgs::msg::Pose>({corner.x_m, corner.y_m, 0}));
    message.poses().push_back(stamped);
  }
  if (plan_.write(std::move(message)) == Status::failed) log().warn("a plan was not sent");
}

void NavigatorComponent::log_change(const Navigator::Status& status) {
  log().info("goal {}: {} {}", status.goal_id, to_string(status.state), status.reason);
}

void NavigatorComponent::go_on_with_earlier_goal(Time now) {
  auto goal = goal_file_.load();
  if (!goal) return;
  const std::uint64_t mission = goal->mission;
  const std::uint64_t id = goal->id;
  if (navigator_.on_goal(std::move(*goal), now) != GoalAnswer::accepted) return;
  mission_ = mission;
  log().info("goes on with goal {} of mission {:x}, which it had before it was restarted", id,
             mission);
}

/// That of a program on the vehicle ends with its connection.
void NavigatorComponent::remember_goal() {
  const auto& goal = navigator_.goal();
  if (!goal) return;
  const bool is_ours = goal->mission == mission_;
  const bool was_saved =
      std::exchange(is_goal_saved_, is_ours ? goal_file_.save(*goal) : goal_file_.clear());
  if (was_saved && !is_goal_saved_) log().warn("the goal cannot be saved for a restart");
}

void NavigatorComponent::remember(Time now) {
  if (now < next_save_) return;
  next_save_ = now + std::chrono::seconds(1);
  remember_goal();
  if (!pose_ || amcl_pose_) return;
  const bool was_saved = std::exchange(is_saved_, file_.save(localiser_.memory()));
  if (was_saved && !is_saved_) log().warn("the pose cannot be saved for a restart");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::NavigatorComponent)
