// SPDX-License-Identifier: Apache-2.0
#include "navigator/goal_list.hpp"

#include <algorithm>
#include <utility>

namespace tocsin {
namespace {

bool is_valid(const Goal& goal) {
  return goal.id != 0 && is_finite(goal.pose) && goal.tolerance_m >= 0.05 &&
         goal.tolerance_m <= 5 && goal.ahead.size() <= Goal::most_ahead &&
         std::all_of(goal.ahead.begin(), goal.ahead.end(),
                     [](const navigation::Pose2& pose) { return is_finite(pose); });
}

}  // namespace

GoalAnswer GoalList::on_goal(Goal goal, Time now) {
  if (!is_valid(goal)) return GoalAnswer::invalid;
  if (goal.expires <= now) return GoalAnswer::expired;
  if (!goal_ || goal.id > goal_->id) {
    goal_ = std::move(goal);
    return GoalAnswer::accepted;
  }
  const std::uint64_t passed = goal_->id - goal.id;
  if (passed > goal.ahead.size()) return GoalAnswer::superseded;
  goal_->expires = std::max(goal_->expires, goal.expires);
  goal_->ahead.assign(goal.ahead.begin() + static_cast<std::ptrdiff_t>(passed), goal.ahead.end());
  return GoalAnswer::renewed;
}

bool GoalList::advance() {
  if (!goal_ || goal_->ahead.empty()) return false;
  ++goal_->id;
  goal_->pose = goal_->ahead.front();
  goal_->ahead.erase(goal_->ahead.begin());
  return true;
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
