// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "ros_idl/action_msgs.hpp"
#include "runtime/component.hpp"
#include "runtime/middleware/goal_table.hpp"
#include "runtime/service_port.hpp"

namespace tocsin {

/// The service that ends goals; the same types for every action.
struct CancelGoal {
  using Request = action_msgs::srv::CancelGoal_Request;
  using Response = action_msgs::srv::CancelGoal_Response;
};

/// The two services of an action that have types of its own.
template <class Action>
struct ActionServices {
  struct SendGoal {
    using Request = typename Action::SendGoalRequest;
    using Response = typename Action::SendGoalResponse;
  };
  struct GetResult {
    using Request = typename Action::GetResultRequest;
    using Response = typename Action::GetResultResponse;
  };
};

/// As long a client waits for the reason of a rejection.
constexpr Duration reason_wait = std::chrono::seconds(1);

/// "dock/_action/send_goal".
[[nodiscard]] std::string action_end(const std::string& action, const char* end);
/// A topic of an action: its feedback or its status.
[[nodiscard]] TopicInfo action_topic(const std::string& action, const char* end, const char* qos);

/// What all action servers have alike: the goals, the service that ends them, and their status.
class ActionServerPort {
 public:
  ActionServerPort(Component& owner, const std::string& action);

  /// The state of a goal; unknown when it was not accepted, or is over since long ago.
  [[nodiscard]] GoalState state(const GoalId& id) const { return goals_.state(id); }
  /// Whether somebody wants the goal to end. It is the component's to end it then.
  [[nodiscard]] bool is_canceling(const GoalId& id) const {
    return state(id) == GoalState::canceling;
  }

 protected:
  /// Ends goals that somebody wants to end; the ids of those that are forgotten.
  std::vector<GoalId> serve_cancels(Time now);
  /// When it was accepted [ns]; nothing when there is one of this id.
  std::optional<std::int64_t> take_up(const GoalId& id, Time now);
  /// Of a goal that may: asserted.
  void apply(const GoalId& id, GoalEvent event, Time now);
  [[nodiscard]] Component& owner() { return owner_; }

 private:
  void tell_status();
  Component& owner_;
  GoalTable goals_;
  Server<CancelGoal> cancel_;
  std::unique_ptr<Publication> status_;
};

/// Makes ids of goals that no other client has: of its component's name, the time and a count.
class GoalIds {
 public:
  explicit GoalIds(Component& owner);
  GoalId next();

 private:
  std::mt19937_64 random_;
};

}  // namespace tocsin
