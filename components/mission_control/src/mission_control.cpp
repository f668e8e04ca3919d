// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin {

using navigation::Pose2;

namespace {

/// FNV-1a over the waypoints in millimetres, folded to the 10 bits that a goal's id has for it.
std::uint32_t checksum_of(const navigation::Mission& mission) {
  std::uint32_t hash = 2166136261U;
  const auto add = [&hash](double metres) {
    const auto millimetres = static_cast<std::uint64_t>(std::llround(metres * 1000));
    for (unsigned shift = 0; shift < 64; shift += 8) {
      hash = (hash ^ static_cast<std::uint32_t>(millimetres >> shift & 0xffU)) * 16777619U;
    }
  };
  for (const Pose2& waypoint : mission.waypoints) {
    add(waypoint.x);
    add(waypoint.y);
  }
  return (hash ^ hash >> 10U ^ hash >> 20U) & 0x3ffU;
}

}  // namespace

MissionControl::MissionControl(const Params& params, navigation::Mission mission)
    : params_(params), mission_(std::move(mission)), checksum_(checksum_of(mission_)) {
  if (mission_.waypoints.empty()) throw ConfigError("mission.waypoints: there is none");
  if (params.goal_lifetime_s <= 2 * params.repeat_after_s) {
    throw ConfigError("goal_lifetime_s: " + std::to_string(params.goal_lifetime_s) +
                      " is not above twice repeat_after_s (" +
                      std::to_string(params.repeat_after_s) + ")");
  }
}

void MissionControl::on_location(const Pose2& location, Time now) {
  if (!is_finite(location)) return;
  location_ = location;
  if (!first_heard_) first_heard_ = now;
}

void MissionControl::on_status(std::uint64_t goal_id, const std::string& state, Time now) {
  status_goal_ = goal_id;
  status_ = state;
  status_time_ = now;
  newest_id_ = std::max(newest_id_, goal_id);
  if (!first_heard_) first_heard_ = now;
  const bool is_blocked = state == "blocked" && goal_id_ == goal_id;
  if (!is_blocked) blocked_since_.reset();
  if (is_blocked && !blocked_since_) blocked_since_ = now;
}

std::optional<MissionControl::Goal> MissionControl::update(Time now, std::uint64_t wall_ms) {
  if (state_ == State::waiting) start_when_ready(now);
  if (state_ == State::running && goal_id_) check_arrival(now);
  if (state_ == State::running && goal_id_) check_limits(now);
  if (state_ != State::running || !is_due(now)) return std::nullopt;
  return issue(now, wall_ms);
}

void MissionControl::start_when_ready(Time now) {
  if (!first_heard_) return;
  const bool knows_goal = status_goal_ != 0;
  if (!knows_goal && now - *first_heard_ < seconds(params_.resume_wait_s)) return;
  state_ = State::running;
  started_ = now;
  waypoint_since_ = now;
  if (knows_goal && params_.resume) resume_from(status_goal_);
}

void MissionControl::resume_from(std::uint64_t goal_id) {
  const GoalId id = GoalId::unpack(goal_id);
  if (id.mission != checksum_ || id.waypoint >= mission_.waypoints.size()) return;
  waypoint_ = id.waypoint;
  goal_id_ = goal_id;
}

void MissionControl::check_arrival(Time now) {
  if (has_gone_on()) {
    while (has_gone_on()) arrive(false, now);
  } else if (distance_m() <= params_.arrival_m) {
    arrive(true, now);
  } else if (status_ == "reached" && status_goal_ == goal_id_) {
    arrive(false, now);
  }
}

/// The vehicle drives to a later waypoint of the goal that it was sent.
bool MissionControl::has_gone_on() const {
  if (state_ != State::running) return false;
  const GoalId told = GoalId::unpack(status_goal_);
  const GoalId own = GoalId::unpack(*goal_id_);
  return told.issued_ms == own.issued_ms && told.mission == own.mission &&
         told.waypoint > waypoint_ && told.waypoint < mission_.waypoints.size();
}

void MissionControl::arrive(bool by_location, Time now) {
  arrivals_.push_back({waypoint_, by_location, distance_m(), to_seconds(now - waypoint_since_),
                       goals_for_waypoint_});
  blocked_since_.reset();
  goals_for_waypoint_ = 0;
  waypoint_since_ = now;
  if (waypoint_ + 1 == mission_.waypoints.size()) return finish(State::done, "", now);
  ++waypoint_;
  ++*goal_id_;  // as told ahead
}

void MissionControl::check_limits(Time now) {
  const std::string name = "waypoint " + std::to_string(waypoint_ + 1);
  if (blocked_since_ && now - *blocked_since_ > seconds(params_.blocked_limit_s)) {
    finish(State::aborted, name + " is blocked", now);
  } else if (now - waypoint_since_ > seconds(params_.waypoint_limit_s)) {
    finish(State::aborted, name + " was not reached in time", now);
  }
}

void MissionControl::finish(State state, std::string reason, Time now) {
  state_ = state;
  reason_ = std::move(reason);
  ended_ = now;
}

bool MissionControl::is_due(Time now) const {
  if (!goal_id_ || goals_for_waypoint_ == 0) return true;
  // A vehicle that is not heard may not hear either, and its lease runs.
  const bool is_heard = now - status_time_ < seconds(params_.repeat_after_s);
  const bool is_answered = status_goal_ == goal_id_ && status_ != "held" && is_heard;
  return now - sent_ >= seconds(is_answered ? params_.goal_lifetime_s / 2 : params_.repeat_after_s);
}

MissionControl::Goal MissionControl::issue(Time now, std::uint64_t wall_ms) {
  if (!goal_id_ || *goal_id_ < newest_id_) {
    const std::uint64_t issued_ms = std::max(wall_ms, GoalId::unpack(newest_id_).issued_ms + 1);
    goal_id_ = GoalId{issued_ms, checksum_, waypoint_}.packed();
  }
  newest_id_ = *goal_id_;
  sent_ = now;
  ++goals_sent_;
  ++goals_for_waypoint_;
  return {*goal_id_,
          waypoint_,
          mission_.waypoints[waypoint_],
          params_.tolerance_m,
          params_.goal_lifetime_s,
          waypoints_ahead()};
}

std::vector<Pose2> MissionControl::waypoints_ahead() const {
  const auto next = mission_.waypoints.begin() + waypoint_ + 1;
  const auto left = mission_.waypoints.end() - next;
  return {next, next + std::min<std::ptrdiff_t>(params_.goals_ahead, left)};
}

double MissionControl::distance_m() const {
  if (!location_) return std::numeric_limits<double>::quiet_NaN();
  return distance(position(*location_), position(mission_.waypoints[waypoint_]));
}

MissionControl::Progress MissionControl::progress(Time now) const {
  Progress progress;
  progress.state = state_;
  progress.waypoint = waypoint_;
  progress.waypoints = static_cast<std::uint32_t>(mission_.waypoints.size());
  progress.goals_sent = goals_sent_;
  progress.reason = reason_;
  const bool is_over = state_ == State::done || state_ == State::aborted;
  if (started_) progress.elapsed_s = to_seconds((is_over ? ended_ : now) - *started_);
  return progress;
}

const char* to_string(MissionControl::State state) {
  switch (state) {
    case MissionControl::State::waiting:
      return "waiting";
    case MissionControl::State::running:
      return "running";
    case MissionControl::State::done:
      return "done";
    case MissionControl::State::aborted:
      return "aborted";
  }
  return "";
}

}  // namespace tocsin
