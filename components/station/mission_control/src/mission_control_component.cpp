// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control_component.hpp"

#include <algorithm>
#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "geometry/pose_message.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

std::optional<navigation::Mission> load_checked_mission(
    const MissionControlComponent::Params& params) {
  if (params.mission_file.empty()) return std::nullopt;
  auto mission = navigation::load_mission(params.mission_file);
  if (!params.map_file.empty()) {
    require_free(mission, navigation::load_map(params.map_file), params.robot_radius_m);
  }
  return mission;
}

MissionAction make_action(const MissionControlComponent::Params& params) {
  if (params.map_file.empty()) return MissionAction();
  return MissionAction(navigation::load_map(params.map_file), params.robot_radius_m);
}

/// Two starts never begin in the same nanosecond, and a simulated one begins always in the same.
std::uint64_t seed_of(const Bus& bus) { return static_cast<std::uint64_t>(bus.wall_ns(bus.now())); }

bool differ(const MissionControl::Progress& a, const MissionControl::Progress& b) {
  return a.state != b.state || a.waypoint != b.waypoint || a.goals_sent != b.goals_sent;
}

}  // namespace

MissionControlComponent::MissionControlComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      control_(params.control, load_checked_mission(params), seed_of(context.bus)),
      waypoints_(*this, make_action(params)) {
  wake_every(seconds(1 / params.rate_hz));
}

void MissionControlComponent::tick(Time now) {
  take_inputs(now);
  take_orders(now);
  waypoints_.take(control_, now);
  if (const auto goal = control_.update(now)) send(*goal, now);
  waypoints_.follow(control_, now);
  log_arrivals();
  publish_path(now);
  report(now);
}

void MissionControlComponent::take_inputs(Time now) {
  if (const auto location = location_.take_latest())
    control_.on_location(geometry::pose_in(location->pose().pose()), now);
  while (const auto status = navigation_.take()) {
    control_.on_status({status->mission(), status->goal_id()}, status->state(), now);
  }
}

void MissionControlComponent::take_orders(Time now) {
  while (const auto words = orders_.take()) {
    const auto order = mission_order_of(words->data());
    if (!order) {
      log().warn("{}: '{}' is not one of: pause, resume, skip N", topic::MissionCommand::info.name,
                 printable(words->data()));
    } else {
      control_.obey(*order, now);
    }
  }
}

void MissionControlComponent::send(const MissionControl::Goal& goal, Time now) {
  topic::Goal::Message message;
  message.stamp(wall(now));
  message.mission(goal.name.mission);
  message.id(goal.name.id);
  message.waypoint(goal.waypoint);
  message.x(goal.pose.x_m);
  message.y(goal.pose.y_m);
  message.yaw(goal.pose.heading_rad);
  message.send_s(goal.pose.send_s);
  message.tolerance_m(goal.tolerance_m);
  message.lifetime_s(goal.lifetime_s);
  for (const navigation::Waypoint& place : goal.ahead) {
    message.ahead().emplace_back();
    message.ahead().back().x(place.x_m);
    message.ahead().back().y(place.y_m);
    message.ahead().back().yaw(place.heading_rad);
    message.ahead().back().send_s(place.send_s);
  }
  if (goal_.write(std::move(message)) == Status::failed) log().warn("a goal was not sent");
}

void MissionControlComponent::log_arrivals() {
  // Another mission has arrivals of its own.
  arrivals_logged_ = std::min(arrivals_logged_, control_.arrivals().size());
  for (; arrivals_logged_ < control_.arrivals().size(); ++arrivals_logged_) {
    const auto& arrival = control_.arrivals()[arrivals_logged_];
    log().info("waypoint {} reached after {:.1f} s, {:.2f} m away, told by {}, {} goals sent",
               arrival.waypoint + 1, arrival.after_s, arrival.distance_m,
               arrival.by_location ? "location" : "status", arrival.goals);
  }
}

std::string MissionControlComponent::mission_name() const {
  return control_.mission().waypoints.empty() ? "none" : control_.mission().name;
}

void MissionControlComponent::publish_path(Time now) {
  if (published_missions_ == control_.missions()) return;
  topic::MissionPath::Message path;
  path.header().stamp(wall(now));
  path.header().frame_id("map");
  for (const geometry::Pose& waypoint : control_.mission().waypoints) {
    path.poses().emplace_back();
    path.poses().back().header(path.header());
    path.poses().back().pose(geometry::pose_message<geometry_msgs::msg::Pose>(waypoint));
  }
  if (path_.write(std::move(path)) == Status::ok) published_missions_ = control_.missions();
}

void MissionControlComponent::report(Time now) {
  const auto progress = control_.progress(now);
  const bool has_changed = differ(progress, reported_);
  if (!has_changed && now < next_report_) return;
  topic::MissionStatus::Message message;
  message.stamp(wall(now));
  message.mission(mission_name());
  message.state(word_of(progress.state));
  message.waypoint(progress.waypoint);
  message.waypoints(progress.waypoints);
  message.goals_sent(progress.goals_sent);
  message.elapsed_s(progress.elapsed_s);
  if (status_.write(std::move(message)) == Status::failed) return;
  if (progress.state != reported_.state) {
    log().info("mission {}: {} {}", mission_name(), word_of(progress.state), progress.reason);
    end_when_over(progress.state);
  }
  waypoints_.tell(control_, now);
  reported_ = progress;
  next_report_ = next_instant(seconds(params_.status_period_s), now);
}

void MissionControlComponent::end_when_over(MissionControl::State state) {
  const bool is_replaced = !params_.mission_file.empty() && control_.missions() > 1;
  if (!params_.exit_when_over || is_replaced) return;
  if (state == MissionControl::State::done) context().request_exit(0);
  if (state == MissionControl::State::aborted) context().request_exit(1);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::MissionControlComponent)
