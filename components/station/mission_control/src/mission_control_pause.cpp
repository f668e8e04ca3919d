// SPDX-License-Identifier: Apache-2.0
// What is asked of a mission while it runs.
#include <utility>

#include "mission_control/mission_control.hpp"

namespace tocsin {

void MissionControl::obey(const MissionOrder& order, Time now) {
  switch (order.kind) {
    case MissionOrder::Kind::pause:
      return pause(now);
    case MissionOrder::Kind::resume:
      return go_on(now);
    case MissionOrder::Kind::skip:
      return skip(order.waypoint, now);
  }
}

void MissionControl::pause(Time now) {
  if (state_ != State::running && state_ != State::waiting) return;
  state_before_pause_ = std::exchange(state_, State::paused);
  paused_since_ = now;
  is_held_ = false;
  goals_for_waypoint_ = 0;
}

/// The goals after a pause are of another identity: the goal of the pause has a greater id.
void MissionControl::go_on(Time now) {
  if (state_ != State::paused) return;
  state_ = state_before_pause_;
  waypoint_since_ += now - paused_since_;
  blocked_since_.reset();
  goals_for_waypoint_ = 0;
  if (has_begun_) draw_identity();
}

void MissionControl::stop(std::string reason, Time now) {
  if (state_ != State::waiting && state_ != State::running && state_ != State::paused) return;
  if (state_ != State::paused) is_held_ = false;
  goals_for_waypoint_ = 0;
  is_halting_ = true;
  finish(State::aborted, std::move(reason), now);
}

bool MissionControl::has_stopped(Time now) const {
  if (!has_begun_ || now >= leased_until_) return true;
  if (told_.mission != identity_) return was_taken_over();
  return told_.id == held().id && status_ != "driving";
}

void MissionControl::skip(std::uint32_t waypoint, Time now) {
  if (state_ != State::running || waypoint != waypoint_) return;
  if (waypoint_ + 1 == mission_.waypoints.size()) return;
  ++waypoint_;
  waypoint_since_ = now;
  blocked_since_.reset();
  goals_for_waypoint_ = 0;
}

/// Where the vehicle is, as a goal; until it has named that, and none before a mission has begun.
std::optional<MissionControl::Goal> MissionControl::hold(Time now) {
  constexpr double near_m = 0.5;  // it rolls on while it is told
  if (told_.mission == identity_ && told_.id == held().id) is_held_ = true;
  if (!has_begun_ || is_held_ || !location_) return std::nullopt;
  if (goals_for_waypoint_ > 0 && now - sent_ < seconds(params_.repeat_after_s)) return std::nullopt;
  sent_ = now;
  ++goals_sent_;
  ++goals_for_waypoint_;
  return Goal{held(), waypoint_, {*location_}, near_m, params_.goal_lifetime_s, {}};
}

}  // namespace tocsin
