// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin {

namespace {

constexpr std::size_t remembered_identities = 16;

/// FNV-1a over the waypoints in millimetres.
std::uint32_t checksum_of(const navigation::Mission& mission) {
  std::uint32_t hash = 2166136261U;
  const auto add = [&hash](double metres) {
    const auto millimetres = static_cast<std::uint64_t>(std::llround(metres * 1000));
    for (unsigned shift = 0; shift < 64; shift += 8) {
      hash = (hash ^ static_cast<std::uint32_t>(millimetres >> shift & 0xffU)) * 16777619U;
    }
  };
  for (const geometry::Pose& waypoint : mission.waypoints) {
    add(waypoint.x_m);
    add(waypoint.y_m);
  }
  return hash;
}

/// Step and finish of SplitMix64 (Steele, Lea, Flood 2014): equal seeds give equal rows, and seeds
/// that lie close together rows that do not.
std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9E3779B97F4A7C15ULL;
  z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ z >> 27U) * 0x94D049BB133111EBULL;
  return z ^ z >> 31U;
}

}  // namespace

MissionControl::MissionControl(const Params& params, std::optional<navigation::Mission> mission,
                               std::uint64_t seed)
    : params_(params), seed_(seed) {
  if (mission && mission->waypoints.empty()) throw ConfigError("mission.waypoints: there is none");
  if (params.goal_lifetime_s <= 2 * params.repeat_after_s) {
    throw ConfigError("goal_lifetime_s: " + std::to_string(params.goal_lifetime_s) +
                      " is not above twice repeat_after_s (" +
                      std::to_string(params.repeat_after_s) + ")");
  }
  if (mission) begin(std::move(*mission));
}

void MissionControl::begin(navigation::Mission mission) {
  mission_ = std::move(mission);
  ++missions_;
  checksum_ = checksum_of(mission_);
  state_ = State::waiting;
  draw_identity();
}

void MissionControl::lead(navigation::Mission mission) {
  assert(!mission.waypoints.empty());
  begin(std::move(mission));
  may_resume_ = false;
  reason_.clear();
  is_halting_ = false;
  waypoint_ = 0;
  arrivals_.clear();
  goals_sent_ = 0;
  goals_for_waypoint_ = 0;
  started_.reset();
  has_begun_ = false;
  blocked_since_.reset();
}

void MissionControl::draw_identity() {
  if (identity_ != 0) own_.push_back(identity_);
  if (own_.size() > remembered_identities) own_.pop_front();
  identity_ = (next_random(seed_) & 0xFFFFFFFF00000000ULL) | checksum_;
}

void MissionControl::on_location(const geometry::Pose& location, Time now) {
  if (!is_finite(location)) return;
  location_ = location;
  if (!first_heard_) first_heard_ = now;
}

void MissionControl::on_status(const GoalName& goal, const std::string& state, Time now) {
  told_ = goal;
  status_ = state;
  status_time_ = now;
  if (!first_heard_) first_heard_ = now;
  const bool is_blocked = state == "blocked" && is_told_present();
  if (!is_blocked) blocked_since_.reset();
  if (is_blocked && !blocked_since_) blocked_since_ = now;
}

std::optional<MissionControl::Goal> MissionControl::update(Time now) {
  if (state_ == State::waiting) start_when_ready(now);
  if (state_ == State::paused) return hold(now);
  if (is_halting_ && !has_stopped(now)) return hold(now);
  if (state_ == State::running && has_begun_) check_arrival(now);
  if (state_ == State::running && has_begun_) check_limits(now);
  if (state_ != State::running || !is_due(now)) return std::nullopt;
  return issue(now);
}

void MissionControl::start_when_ready(Time now) {
  if (!first_heard_) return;
  const bool knows_goal = told_.id != 0;
  const bool is_early = now - *first_heard_ < seconds(params_.resume_wait_s);
  if (may_resume_ && !knows_goal && is_early) return;
  state_ = State::running;
  started_ = now;
  waypoint_since_ = now;
  if (may_resume_ && knows_goal && params_.resume) resume_earlier();
}

/// Goes on where an earlier mission control was with this mission, if the vehicle tells of one.
void MissionControl::resume_earlier() {
  if (static_cast<std::uint32_t>(told_.mission) != checksum_) return;
  const bool was_paused = told_.id > hold_base;
  const std::uint64_t id = was_paused ? told_.id - hold_base : told_.id;
  if (id == 0 || id > mission_.waypoints.size()) return;
  identity_ = told_.mission;
  waypoint_ = static_cast<std::uint32_t>(id - 1);
  has_begun_ = true;
  if (was_paused) pause(*started_);
}

bool MissionControl::is_told_waypoint() const {
  return told_.id != 0 && told_.id <= mission_.waypoints.size();
}

/// Whether the vehicle names the goal of the present waypoint.
bool MissionControl::is_told_present() const {
  return has_begun_ && told_.mission == identity_ && told_.id == present().id;
}

/// Whether the vehicle has said, after the last goal that it was sent, that it drives to one that
/// was not sent from here.
bool MissionControl::was_taken_over() const {
  if (told_.id == 0 || status_time_ <= sent_) return false;
  if (told_.mission == identity_) return !is_told_waypoint();
  return std::find(own_.begin(), own_.end(), told_.mission) == own_.end();
}

void MissionControl::check_arrival(Time now) {
  if (has_gone_on()) {
    while (has_gone_on()) arrive(false, now);
  } else if (mission_.waypoints[waypoint_].send_s == 0 && distance_m() <= params_.arrival_m) {
    arrive(true, now);
  } else if (status_ == "reached" && is_told_present()) {
    arrive(false, now);
  }
}

/// The vehicle drives to a later waypoint of the goal that it was sent.
bool MissionControl::has_gone_on() const {
  return state_ == State::running && told_.mission == identity_ && is_told_waypoint() &&
         told_.id > present().id;
}

void MissionControl::arrive(bool by_location, Time now) {
  arrivals_.push_back({waypoint_, by_location, distance_m(), to_seconds(now - waypoint_since_),
                       goals_for_waypoint_});
  blocked_since_.reset();
  goals_for_waypoint_ = 0;
  waypoint_since_ = now;
  if (waypoint_ + 1 == mission_.waypoints.size()) return finish(State::done, "", now);
  ++waypoint_;
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
  if (!has_begun_ || goals_for_waypoint_ == 0) return true;
  // A vehicle that is not heard may not hear either, and its lease runs.
  const bool is_heard = now - status_time_ < seconds(params_.repeat_after_s);
  const bool is_answered = is_told_present() && status_ != "held" && is_heard;
  return now - sent_ >= seconds(is_answered ? params_.goal_lifetime_s / 2 : params_.repeat_after_s);
}

MissionControl::Goal MissionControl::issue(Time now) {
  if (has_begun_ && was_taken_over()) draw_identity();
  has_begun_ = true;
  sent_ = now;
  leased_until_ = now + seconds(params_.goal_lifetime_s);
  ++goals_sent_;
  ++goals_for_waypoint_;
  return {present(),
          waypoint_,
          mission_.waypoints[waypoint_],
          params_.tolerance_m,
          params_.goal_lifetime_s,
          waypoints_ahead()};
}

std::vector<navigation::Waypoint> MissionControl::waypoints_ahead() const {
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

}  // namespace tocsin
