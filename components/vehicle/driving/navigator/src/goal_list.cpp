// SPDX-License-Identifier: Apache-2.0
#include "navigator/goal_list.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tocsin {
namespace {

bool is_valid(const navigation::Waypoint& place) {
  return is_finite(place) && place.send_s >= 0 && place.send_s <= navigation::Waypoint::most_send_s;
}

bool is_valid(const Goal& goal) {
  const std::uint64_t ids_left = std::numeric_limits<std::uint64_t>::max() - goal.id;
  return goal.id != 0 && goal.ahead.size() <= ids_left && is_valid(goal.pose) &&
         goal.tolerance_m >= 0.05 && goal.tolerance_m <= 5 &&
         goal.ahead.size() <= Goal::most_ahead &&
         std::all_of(goal.ahead.begin(), goal.ahead.end(),
                     [](const navigation::Waypoint& place) { return is_valid(place); });
}

}  // namespace

GoalAnswer GoalList::on_goal(Goal goal, Time now) {
  if (!is_valid(goal)) return GoalAnswer::invalid;
  if (goal.expires <= now) return GoalAnswer::expired;
  const bool is_same_mission = goal_ && goal.mission == goal_->mission;
  if (!is_same_mission && is_over(goal.mission)) return GoalAnswer::superseded;
  if (!is_same_mission || goal.id > goal_->id) {
    take_up(std::move(goal));
    return GoalAnswer::accepted;
  }
  const std::uint64_t passed = goal_->id - goal.id;
  if (passed > goal.ahead.size()) return GoalAnswer::superseded;
  goal_->expires = std::max(goal_->expires, goal.expires);
  goal_->ahead.assign(goal.ahead.begin() + static_cast<std::ptrdiff_t>(passed), goal.ahead.end());
  return GoalAnswer::renewed;
}

bool GoalList::is_over(std::uint64_t mission) const {
  return std::find(over_.begin(), over_.end(), mission) != over_.end();
}

void GoalList::take_up(Goal goal) {
  if (goal_ && goal_->mission != goal.mission) {
    over_.push_back(goal_->mission);
    if (over_.size() > remembered) over_.pop_front();
  }
  goal_ = std::move(goal);
  ++number_;
}

bool GoalList::advance() {
  if (!goal_ || goal_->ahead.empty()) return false;
  ++goal_->id;
  ++number_;
  goal_->pose = goal_->ahead.front();
  goal_->ahead.erase(goal_->ahead.begin());
  return true;
}

void GoalList::expire(Time now) {
  if (!goal_) return;
  goal_->expires = std::min(goal_->expires, now);
  goal_->ahead.clear();
}

const char* to_string(GoalAnswer answer) {
  switch (answer) {
    case GoalAnswer::accepted:
      return "accepted";
    case GoalAnswer::renewed:
      return "renewed";
    case GoalAnswer::superseded:
      return "superseded";
    case GoalAnswer::expired:
      return "expired";
    case GoalAnswer::invalid:
      return "invalid";
  }
  return "";
}

}  // namespace tocsin
