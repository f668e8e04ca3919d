// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_action.hpp"

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin {
namespace {

using State = MissionControl::State;

constexpr const char* map_frame = "map";

/// Empty: the goal makes sense by itself.
std::string reason_to_reject(const WaypointsGoal& goal) {
  if (goal.poses.empty()) return "poses: there is none";
  const std::size_t count = goal.poses.size();
  if (goal.first >= count) {
    return "goal_index: " + std::to_string(goal.first) + " is outside [0, " +
           std::to_string(count - 1) + "]";
  }
  const std::uint64_t waypoints = (goal.loops + std::uint64_t{1}) * count - goal.first;
  if (count > navigation::most_waypoints || waypoints > navigation::most_waypoints) {
    return "poses: with all loops " + std::to_string(waypoints) + ", more than " +
           std::to_string(navigation::most_waypoints);
  }
  for (const WaypointsGoal::Place& place : goal.poses) {
    if (!place.frame.empty() && place.frame != map_frame) {
      return "frame_id: " + printable(place.frame) + " is not " + map_frame;
    }
    if (!is_finite(place.pose)) return "poses: one is not finite";
  }
  return "";
}

navigation::Mission mission_of(const WaypointsGoal& goal) {
  navigation::Mission mission{"follow_waypoints", map_frame, {}, "goal of follow_waypoints"};
  for (std::uint32_t loop = 0; loop <= goal.loops; ++loop) {
    for (std::size_t i = loop == 0 ? goal.first : 0; i < goal.poses.size(); ++i) {
      mission.waypoints.push_back({goal.poses[i].pose});
    }
  }
  return mission;
}

}  // namespace

MissionAction::MissionAction(std::optional<navigation::OccupancyMap> map, double robot_radius_m)
    : map_(std::move(map)), robot_radius_m_(robot_radius_m) {}

std::string MissionAction::begin(const WaypointsGoal& goal, MissionControl& control) {
  std::string reason = reason_to_reject(goal);
  if (!reason.empty()) return reason;
  navigation::Mission mission = mission_of(goal);
  try {
    if (map_) require_free(mission, *map_, robot_radius_m_);
  } catch (const ConfigError& error) {
    return error.what();
  }
  control.lead(std::move(mission));
  poses_ = static_cast<std::uint32_t>(goal.poses.size());
  first_ = goal.first;
  is_canceling_ = false;
  return "";
}

void MissionAction::cancel(MissionControl& control, Time now) {
  is_canceling_ = true;
  control.stop("canceled", now);
}

std::uint32_t MissionAction::index_of(std::uint32_t waypoint) const {
  return (first_ + waypoint) % poses_;
}

std::uint32_t MissionAction::current(const MissionControl& control, Time now) const {
  return index_of(control.progress(now).waypoint);
}

std::vector<std::uint32_t> MissionAction::missed(const MissionControl& control, Time now) const {
  const auto& arrivals = control.arrivals();
  const auto is_missed = [&](std::uint32_t waypoint) {
    return std::none_of(arrivals.begin(), arrivals.end(),
                        [=](const auto& arrival) { return arrival.waypoint == waypoint; });
  };
  std::vector<std::uint32_t> missed;
  const std::uint32_t last = control.progress(now).waypoint;
  for (std::uint32_t waypoint = 0; waypoint <= last; ++waypoint) {
    if (is_missed(waypoint)) missed.push_back(index_of(waypoint));
  }
  return missed;
}

std::optional<WaypointsEnd> MissionAction::end(const MissionControl& control, Time now) const {
  using Kind = WaypointsEnd::Kind;
  const auto progress = control.progress(now);
  const auto ended = [&](Kind kind) {
    return WaypointsEnd{kind, missed(control, now), progress.reason};
  };
  if (progress.state == State::done) return ended(Kind::succeeded);
  if (progress.state != State::aborted) return std::nullopt;
  if (!is_canceling_) return ended(Kind::aborted);
  if (!control.has_stopped(now)) return std::nullopt;
  return ended(Kind::canceled);
}

}  // namespace tocsin
