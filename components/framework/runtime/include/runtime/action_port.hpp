// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "runtime/middleware/action_ports.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// Member of a component that works on goals of an action (tocsin_idl/actions.hpp):
///
///     tocsin::ActionServer<tocsin::action::NavigateToPose> drive_{*this};
///
/// A tick takes goals, accepts or rejects each at once, tells how it goes, and ends those that it
/// has accepted: each has one end. Any client may ask for the end of any goal; that is granted, and
/// the component ends the goal as soon as it can. Clients of rclcpp and rclpy are served alike.
template <class Action>
class ActionServer : public ActionServerPort {
 public:
  using Goal = typename Action::Goal;
  using Result = typename Action::Result;
  using Feedback = typename Action::Feedback;
  struct Asked {
    GoalId id;
    std::shared_ptr<const Goal> goal;
  };
  explicit ActionServer(Component& owner);

  /// The oldest goal that was not taken yet; in each tick until there is none, as this serves all
  /// other requests, too. What is not accepted before the next call is rejected by it.
  [[nodiscard]] std::optional<Asked> take(Time now);
  /// The goal that was taken last is worked on from now on.
  void accept(Time now);
  /// The goal that was taken last is nothing to work on. ROS 2's answer has no room for a reason;
  /// who asks for the goal's result gets `why` for a while, with the state unknown.
  void reject(Result why = {});
  /// How the work on a goal goes. Never blocks.
  void feedback(const GoalId& id, Feedback feedback);
  /// Ends a goal: it is reached; the component gives it up; or, of one that is canceling, its end
  /// was asked for. Asserts that it may end so.
  void succeed(const GoalId& id, Result result, Time now);
  void abort(const GoalId& id, Result result, Time now);
  void canceled(const GoalId& id, Result result, Time now);

 private:
  using SendGoal = typename ActionServices<Action>::SendGoal;
  using GetResult = typename ActionServices<Action>::GetResult;
  struct Ending {
    std::optional<Result> result;  ///< once it is over
    std::deque<CallId> waiting;
  };
  void answer(const CallId& call, std::optional<std::int64_t> accepted_ns);
  void serve_results();
  void finish(const GoalId& id, GoalEvent event, Result result, Time now);
  void reply(const CallId& call, GoalState where, Result result);
  Server<SendGoal> send_goal_;
  Server<GetResult> get_result_;
  std::unique_ptr<Publication> feedback_;
  std::optional<typename Server<SendGoal>::Call> asked_;
  std::map<GoalId, Ending> results_;
  std::deque<std::pair<GoalId, Result>> rejected_;  ///< the last of them, and why
};

/// Member of a component that has goals worked on. Asynchronous: a tick sends a goal, later ones
/// take what comes of it.
template <class Action>
class ActionClient {
 public:
  using Goal = typename Action::Goal;
  using Result = typename Action::Result;
  using Feedback = typename Action::Feedback;
  enum class What {
    accepted,
    rejected,    ///< the last news of this goal; its result says why, where the server tells
    feedback,    ///< how it goes
    canceling,   ///< the server ends it, as was asked
    not_ended,   ///< the server does not end it: it knows it not, it is over, or nobody answers
    result,      ///< it is over; the last news of this goal
    unanswered,  ///< nobody answered until the deadline, whether it runs is not known; the last
  };
  struct News {
    GoalId id;
    What what;
    GoalState state = GoalState::unknown;  ///< of a result
    std::shared_ptr<const Feedback> feedback = {};
    std::shared_ptr<const Result> result = {};
  };
  explicit ActionClient(Component& owner);

  /// Whether somebody works on such goals.
  [[nodiscard]] bool available() const;
  /// Sends it as soon as a server is there. Whether it is accepted is known at `answer_by` at the
  /// latest, how it ends at `result_by`.
  GoalId send(Goal goal, Time answer_by, Time result_by);
  /// Asks for the end of a goal.
  void cancel(const GoalId& id, Time answer_by);
  /// What has come of the goals; in each tick until there is nothing.
  [[nodiscard]] std::optional<News> take(Time now);

 private:
  using SendGoal = typename ActionServices<Action>::SendGoal;
  using GetResult = typename ActionServices<Action>::GetResult;
  struct Sent {
    GoalId id;
    Time result_by;
  };
  std::optional<News> take_answer(Time now);
  std::optional<News> take_cancel(Time now);
  std::optional<News> take_feedback();
  std::optional<News> take_result(Time now);
  CallNumber ask_result(const GoalId& id, Time result_by);
  GoalIds ids_;
  Client<SendGoal> send_goal_;
  Client<GetResult> get_result_;
  Client<CancelGoal> cancel_;
  InputPort feedback_;
  std::map<CallNumber, Sent> sent_;
  std::map<CallNumber, GoalId> running_;
  std::map<CallNumber, GoalId> rejected_;  ///< while their reason is asked for
  std::map<CallNumber, GoalId> cancels_;
};

}  // namespace tocsin

#include "runtime/detail/action_port_definitions.hpp"
