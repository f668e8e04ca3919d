// SPDX-License-Identifier: Apache-2.0
#include "navigator/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "foundation/numbers.hpp"
#include "geometry/pose.hpp"

namespace tocsin {

namespace {

constexpr double home_tolerance_m = 0.2;
constexpr double moved_m = 0.05;  // more is progress
constexpr double turned_rad = 0.1;
constexpr double slow_mps = 0.15;
constexpr double bumper_gap_m = 0.05;  // left between a wall and a vehicle that braked before it
constexpr Duration back_up_time = std::chrono::milliseconds(1500);

geometry::Pose ahead(const geometry::Pose& pose, double metres) {
  return {pose.x_m + metres * std::cos(pose.heading_rad),
          pose.y_m + metres * std::sin(pose.heading_rad), pose.heading_rad};
}

}  // namespace

Navigator::Navigator(const Params& params, const navigation::OccupancyMap& map)
    : Navigator(params, map, std::make_shared<const navigation::CostMap>(map, params.inflation)) {}

Navigator::Navigator(const Params& params, navigation::OccupancyMap map,
                     std::shared_ptr<const navigation::CostMap> costs)
    : params_(params),
      surroundings_(params.surroundings, params.inflation, std::move(map), std::move(costs)),
      follower_(params.follower),
      reconnection_(params.reconnection),
      send_stop_(params.send_stop) {}

void Navigator::set_live(const Params& params) {
  params_.link_lost_after_s = params.link_lost_after_s;
  params_.follower.speed_mps = params.follower.speed_mps;
  follower_.set_speeds(params.follower.speed_mps, params.follower.turn_rate_radps);
}

GoalAnswer Navigator::on_goal(Goal goal, Time now) {
  const GoalAnswer answer = goals_.on_goal(std::move(goal), now);
  if (answer == GoalAnswer::accepted || answer == GoalAnswer::renewed) heard_ = now;
  return answer;
}

void Navigator::on_pose(const geometry::Pose& pose, Time now) {
  if (!is_finite(pose)) return;
  pose_ = pose;
  pose_time_ = now;
  if (!home_) home_ = pose;
}

void Navigator::on_scan(const laser::Scan& scan, const std::optional<geometry::Pose>& pose,
                        Time now) {
  look_around_.on_scan(scan, now);
  if (pose) surroundings_.on_scan(scan, *pose, now);
}

void Navigator::on_touch(double bearing_rad, double away_m, Time now) {
  const geometry::Pose towards{pose_.x_m, pose_.y_m, pose_.heading_rad + bearing_rad};
  surroundings_.on_touch(position(ahead(towards, away_m)), now);
}

Navigator::Output Navigator::update(Time now) {
  const Duration dt = last_update_ ? now - *last_update_ : Duration{0};
  last_update_ = now;
  const char* const halts = reason_to_halt(now);
  if (halts != nullptr) return stand(State::held, look_around(now, dt), halts);
  look_around_.end();
  if (!goals_.present()) return stand(State::idle, follower_.brake(dt), "no_goal");
  if (is_link_lost(now) && params_.on_link_lost == OnLinkLost::go_home) return go_home(now, dt);
  if (reconnects(now)) return reconnect(now, dt);
  const char* const reason = reason_to_hold(now);
  if (reason != nullptr && !stands_at_goal()) {
    return stand(State::held, follower_.brake(dt), reason);
  }
  if (reason == nullptr && stands_at_goal() && !sends_at_goal(now)) (void)goals_.advance();
  const Goal& goal = *goals_.present();
  Output output = drive({goals_.present_number(), goal.pose, goal.tolerance_m}, now, dt);
  return sends_at_goal(now) ? stand(State::held, output.velocity, "sending") : output;
}

/// With a goal, when what is missing is the pose; stands otherwise.
geometry::Twist Navigator::look_around(Time now, Duration dt) {
  const bool is_blind = params_.look_around && !knows_pose(now) && is_busy(now);
  if (!is_blind) look_around_.end();
  if (!is_blind || emergency_stop_) return follower_.halt();
  return follower_.move_at(look_around_.next(now), dt);
}

bool Navigator::is_busy(Time now) const {
  const auto& goal = goals_.present();
  if (!goal || now >= goal->expires) return false;
  return !stands_at_goal() || !goal->ahead.empty();
}

bool Navigator::stands_at_goal() const {
  return reached_ && target_key_ == goals_.present_number();
}

bool Navigator::sends_at_goal(Time now) {
  return stands_at_goal() &&
         send_stop_.stands_at_goal(goals_.present_number(), goals_.present()->pose.send_s, now);
}

bool Navigator::sends_on_way(const Target& target, Time now) {
  const auto& link = surroundings_.link();
  const bool may_stand = params_.send_stop.send_stop_s > 0 && link;
  if (!may_stand || target.key != goals_.present_number()) return false;
  return send_stop_.stands_on_way(target.key, follower_.rest(position(pose_)),
                                  params_.follower.speed_mps, *link, now);
}

Navigator::Status Navigator::status(State state, double distance_m, const char* reason) const {
  const auto& goal = goals_.present();
  return {goal ? goal->mission : 0, goal ? goal->id : 0, state, distance_m, reason};
}

bool Navigator::knows_pose(Time now) const {
  return home_ && now - pose_time_ <= seconds(params_.pose_timeout_s);
}

const char* Navigator::reason_to_halt(Time now) const {
  if (emergency_stop_) return "emergency_stop";
  if (!knows_pose(now)) return "no_pose";
  if (!surroundings_.sees(now)) return "no_scan";
  return nullptr;
}

const char* Navigator::reason_to_hold(Time now) const {
  if (now >= goals_.present()->expires) return "goal_expired";
  if (is_link_lost(now) && params_.on_link_lost == OnLinkLost::hold) return "link_lost";
  return nullptr;
}

bool Navigator::is_link_lost(Time now) const {
  return heard_ && now - *heard_ > seconds(params_.link_lost_after_s);
}

Navigator::Output Navigator::stand(State state, const geometry::Twist& velocity,
                                   const char* reason) {
  progress_pose_ = pose_;
  progress_time_ = *last_update_;
  return {velocity, status(state, nan, reason)};
}

/// Once on the way to each goal, so that one beyond a dead zone is reached, and when it expires.
bool Navigator::reconnects(Time now) {
  if (params_.on_link_lost != OnLinkLost::reconnect) return false;
  if (!is_link_lost(now)) {
    if (!reconnection_.is_on()) return false;
    resumed_goal_ = goals_.present_number();
    target_key_.reset();  // the place, or what was driven to before it
    reconnection_.end();
    return false;
  }
  return reconnection_.is_on() || resumed_goal_ != goals_.present_number() ||
         now >= goals_.present()->expires;
}

Navigator::Output Navigator::reconnect(Time now, Duration dt) {
  const auto& link = surroundings_.link();
  if (!link) return go_home(now, dt);
  const geometry::Point here = position(pose_);
  const auto place =
      reconnection_.place(surroundings_.costs(), *link, here, position(goals_.present()->pose),
                          params_.follower.speed_mps);
  if (!place) return stand(State::held, follower_.brake(dt), "link_lost");
  const geometry::Pose target{place->x_m, place->y_m, pose_.heading_rad};
  constexpr std::uint64_t place_key = std::uint64_t{1} << 63U;  // no goal has such a number
  Output output = drive_unheard({place_key, target, home_tolerance_m}, now, dt);
  const bool is_shut = blocked_since_ && blocked_reason_ == std::string_view("no_path");
  if (is_shut) reconnection_.give_up();
  if (is_shut || (reached_ && reconnection_.on_arrival(now))) target_key_.reset();
  return output;
}

Navigator::Output Navigator::go_home(Time now, Duration dt) {
  return drive_unheard({0, *home_, home_tolerance_m}, now, dt);
}

Navigator::Output Navigator::drive_unheard(const Target& target, Time now, Duration dt) {
  Output output = drive(target, now, dt);
  output.status.state = State::held;  // the goal is not driven to
  output.status.reason = "link_lost";
  output.status.distance_m = nan;
  return output;
}

Navigator::Output Navigator::drive(const Target& target, Time now, Duration dt) {
  if (target_key_ != target.key) take_up(target);
  if (reached_) return {follower_.brake(dt), status(State::reached, 0, "")};
  arrived_ = arrived_ || has_arrived(target);
  if (arrived_) return align(target, dt);
  if (waits_blocked(now)) return wait_blocked(now, dt);
  return drive_path(target, now, dt);
}

/// Near enough and slow, so that braking does not carry the vehicle out of the tolerance again.
bool Navigator::has_arrived(const Target& target) const {
  const double away_m = distance(position(pose_), position(target.pose));
  const bool is_slow = std::abs(follower_.velocity().linear_mps) <= slow_mps;
  return away_m <= target.tolerance_m / 2 || (away_m <= target.tolerance_m && is_slow);
}

void Navigator::take_up(const Target& target) {
  target_key_ = target.key;
  surroundings_.begin_way();
  has_path_ = false;
  arrived_ = false;
  reached_ = false;
  blocked_since_.reset();
  progress_pose_ = pose_;
  progress_time_ = *last_update_;
}

Navigator::Output Navigator::align(const Target& target, Duration dt) {
  const bool is_aligned =
      std::abs(geometry::wrap_angle(target.pose.heading_rad - pose_.heading_rad)) <=
      params_.yaw_tolerance_rad;
  reached_ = is_aligned || !params_.align_yaw;
  if (reached_) return {follower_.brake(dt), status(State::reached, 0, "")};
  const double away_m = distance(position(pose_), position(target.pose));
  return {follower_.turn_to(pose_, target.pose.heading_rad, dt),
          status(State::driving, away_m, "aligning")};
}

Navigator::Output Navigator::drive_path(const Target& target, Time now, Duration dt) {
  if (!has_path_ || surroundings_.wants_plan(now)) {
    auto path = surroundings_.plan(position(pose_), position(target.pose), now);
    if (!path) return block(now, "no_path");
    follower_.start(std::move(*path));
    has_path_ = true;
    ++plans_;
    blocked_since_.reset();
  }
  if (sends_on_way(target, now)) return stand(State::held, follower_.brake(dt), "sending");
  if (is_stuck(now)) return block(now, "stuck");
  const geometry::Twist velocity = follow_with_care(dt);
  // The next update plans from where the vehicle is then.
  if (follower_.deviation_m() > params_.replan_beside_m) has_path_ = false;
  return {velocity, status(State::driving, follower_.remaining_m(), "")};
}

Navigator::Output Navigator::block(Time now, const char* reason) {
  has_path_ = false;
  blocked_since_ = now;
  blocked_reason_ = reason;
  return stand(State::blocked, follower_.halt(), reason);
}

/// Where there was no way, there may be one as soon as something has moved.
bool Navigator::waits_blocked(Time now) const {
  if (!blocked_since_ || now - *blocked_since_ >= seconds(params_.retry_after_s)) return false;
  return blocked_reason_ != std::string_view("no_path") || !surroundings_.wants_plan(now);
}

Navigator::Output Navigator::wait_blocked(Time now, Duration dt) {
  const bool backs_up = blocked_reason_ == std::string_view("stuck") &&
                        now - *blocked_since_ < back_up_time && is_free_behind();
  return stand(State::blocked, backs_up ? follower_.back_up(dt) : follower_.brake(dt),
               blocked_reason_);
}

geometry::Twist Navigator::follow_with_care(Duration dt) {
  if (would_hit()) return follower_.brake(dt);
  const bool stood = follower_.velocity().linear_mps <= 0;
  const geometry::Twist velocity = follower_.follow(pose_, dt, allowed_mps());
  return stood && would_hit() ? follower_.halt() : velocity;
}

/// Slower beside what the map has not: it may move, and its place is known to a cell only.
double Navigator::allowed_mps() const {
  constexpr double least_share = 0.3;
  const double radius_m = params_.inflation.robot_radius_m;
  if (params_.slow_near_m == 0) return infinity;
  const double free_m =
      surroundings_.obstacle_distance_m(position(pose_), radius_m + params_.slow_near_m) - radius_m;
  return params_.follower.speed_mps * std::clamp(free_m / params_.slow_near_m, least_share, 1.0);
}

bool Navigator::would_hit() const {
  const geometry::Twist v = follower_.velocity();
  const double radius_m = params_.inflation.robot_radius_m;
  if (v.linear_mps <= 0) return false;
  const double braking_m =
      v.linear_mps * v.linear_mps / (2 * params_.follower.acceleration_mps2) + bumper_gap_m;
  const bool is_clear = surroundings_.is_clear(pose_.x_m, pose_.y_m, radius_m + braking_m);
  if (is_clear || surroundings_.collides(pose_.x_m, pose_.y_m, radius_m)) return false;
  geometry::Pose pose = pose_;
  constexpr int samples = 4;
  for (int i = 0; i < samples; ++i) {
    pose = ahead(pose, braking_m / samples);
    pose.heading_rad += v.angular_rad_s / v.linear_mps * braking_m / samples;
    if (surroundings_.collides(pose.x_m, pose.y_m, radius_m)) return true;
  }
  return false;
}

bool Navigator::is_free_behind() const {
  const geometry::Pose behind = ahead(pose_, -0.2);
  return !surroundings_.collides(behind.x_m, behind.y_m, params_.inflation.robot_radius_m);
}

bool Navigator::is_stuck(Time now) {
  const bool has_moved =
      distance(position(pose_), position(progress_pose_)) > moved_m ||
      std::abs(geometry::wrap_angle(pose_.heading_rad - progress_pose_.heading_rad)) > turned_rad;
  if (has_moved) {
    progress_pose_ = pose_;
    progress_time_ = now;
  }
  return now - progress_time_ > seconds(params_.stuck_after_s);
}

const char* to_string(Navigator::State state) {
  switch (state) {
    case Navigator::State::idle:
      return "idle";
    case Navigator::State::driving:
      return "driving";
    case Navigator::State::reached:
      return "reached";
    case Navigator::State::blocked:
      return "blocked";
    case Navigator::State::held:
      return "held";
  }
  return "";
}

}  // namespace tocsin
