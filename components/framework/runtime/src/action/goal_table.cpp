// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/goal_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tocsin {
namespace {

struct Step {
  GoalState from;
  GoalEvent event;
  GoalState to;
};

/// rcl_action, goal_state_machine.c.
constexpr std::array steps{
    Step{GoalState::accepted, GoalEvent::execute, GoalState::executing},
    Step{GoalState::accepted, GoalEvent::cancel_goal, GoalState::canceling},
    Step{GoalState::executing, GoalEvent::cancel_goal, GoalState::canceling},
    Step{GoalState::executing, GoalEvent::succeed, GoalState::succeeded},
    Step{GoalState::executing, GoalEvent::abort, GoalState::aborted},
    Step{GoalState::canceling, GoalEvent::succeed, GoalState::succeeded},
    Step{GoalState::canceling, GoalEvent::abort, GoalState::aborted},
    Step{GoalState::canceling, GoalEvent::canceled, GoalState::canceled},
};

bool is_meant(const CancelRequest& request, const KnownGoal& goal) {
  const bool any_id = request.id == GoalId{};
  if (any_id && request.stamp_ns == 0) return true;
  if (!any_id && goal.id == request.id) return true;
  return request.stamp_ns != 0 && goal.accepted_ns <= request.stamp_ns;
}

}  // namespace

GoalId to_uuid(GoalId random) {
  random[6] = static_cast<std::uint8_t>((random[6] & 0x0FU) | 0x40U);
  random[8] = static_cast<std::uint8_t>((random[8] & 0x3FU) | 0x80U);
  return random;
}

std::string goal_text(const GoalId& id) {
  std::string text;
  for (const std::uint8_t byte : id) text += fmt::format("{:02x}", byte);
  return text;
}

const char* to_text(GoalState state) {
  constexpr std::array names{"UNKNOWN",   "ACCEPTED", "EXECUTING", "CANCELING",
                             "SUCCEEDED", "CANCELED", "ABORTED"};
  const auto index = static_cast<std::size_t>(state);
  return index < names.size() ? names[index] : names[0];
}

bool is_over(GoalState state) {
  return state == GoalState::succeeded || state == GoalState::canceled ||
         state == GoalState::aborted;
}

std::optional<GoalState> after(GoalState state, GoalEvent event) {
  for (const Step& step : steps) {
    if (step.from == state && step.event == event) return step.to;
  }
  return std::nullopt;
}

KnownGoal* GoalTable::find(const GoalId& id) {
  const auto found =
      std::find_if(goals_.begin(), goals_.end(), [&](const auto& goal) { return goal.id == id; });
  return found != goals_.end() ? &*found : nullptr;
}

bool GoalTable::add(const GoalId& id, std::int64_t accepted_ns) {
  if (find(id) != nullptr) return false;
  goals_.push_back({id, accepted_ns});
  return true;
}

bool GoalTable::apply(const GoalId& id, GoalEvent event, Time now) {
  KnownGoal* const goal = find(id);
  if (goal == nullptr) return false;
  const auto next = after(goal->state, event);
  if (!next) return false;
  goal->state = *next;
  if (is_over(*next)) goal->ended = now;
  return true;
}

CancelAnswer GoalTable::cancel(const CancelRequest& request, Time now) {
  CancelAnswer answer;
  for (const KnownGoal& goal : goals_) {
    if (!is_meant(request, goal) || !apply(goal.id, GoalEvent::cancel_goal, now)) continue;
    answer.canceling.push_back(goal);
  }
  const bool one_is_meant = request.id != GoalId{} && request.stamp_ns == 0;
  if (one_is_meant && answer.canceling.empty()) {
    answer.code = find(request.id) == nullptr ? CancelCode::unknown_goal : CancelCode::terminated;
  }
  return answer;
}

GoalState GoalTable::state(const GoalId& id) const {
  const auto found =
      std::find_if(goals_.begin(), goals_.end(), [&](const auto& goal) { return goal.id == id; });
  return found != goals_.end() ? found->state : GoalState::unknown;
}

std::vector<GoalId> GoalTable::forget(Time now) {
  std::vector<GoalId> gone;
  const auto is_old = [&](const KnownGoal& goal) {
    return is_over(goal.state) && now - goal.ended > kept_;
  };
  for (const KnownGoal& goal : goals_) {
    if (is_old(goal)) gone.push_back(goal.id);
  }
  goals_.erase(std::remove_if(goals_.begin(), goals_.end(), is_old), goals_.end());
  return gone;
}

}  // namespace tocsin
