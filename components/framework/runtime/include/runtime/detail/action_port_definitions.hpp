// SPDX-License-Identifier: Apache-2.0
// The bodies of action_port.hpp, which includes this.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/action_port.hpp"
#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {

template <class Action>
ActionServer<Action>::ActionServer(Component& owner)
    : ActionServerPort(owner, Action::name),
      send_goal_(owner, action_end(Action::name, "send_goal"), owner.node()),
      get_result_(owner, action_end(Action::name, "get_result"), owner.node()),
      feedback_(owner.bus().advertise({action_topic(Action::name, "feedback", "event"),
                                       &type_info<typename Action::FeedbackMessage>(),
                                       Writers::needed, "", owner.node()})) {}

template <class Action>
std::optional<typename ActionServer<Action>::Asked> ActionServer<Action>::take(Time now) {
  reject();  // what was neither accepted nor rejected
  for (const GoalId& gone : serve_cancels(now)) results_.erase(gone);
  serve_results();
  while (auto call = send_goal_.take()) {
    const auto request = call->request;
    const GoalId& id = request->goal_id().uuid();
    if (state(id) != GoalState::unknown) {
      answer(call->id, std::nullopt);
      continue;
    }
    asked_ = std::move(call);
    return Asked{id, {request, &request->goal()}};
  }
  return std::nullopt;
}

template <class Action>
void ActionServer<Action>::accept(Time now) {
  if (!asked_) return;
  answer(asked_->id, take_up(asked_->request->goal_id().uuid(), now));
  asked_.reset();
}

template <class Action>
void ActionServer<Action>::reject(Result why) {
  constexpr std::size_t most_remembered = 64;
  if (!asked_) return;
  answer(asked_->id, std::nullopt);
  if (rejected_.size() == most_remembered) rejected_.pop_front();
  rejected_.emplace_back(asked_->request->goal_id().uuid(), std::move(why));
  asked_.reset();
}

template <class Action>
void ActionServer<Action>::feedback(const GoalId& id, Feedback feedback) {
  auto message = std::make_shared<typename Action::FeedbackMessage>();
  message->goal_id().uuid(id);
  message->feedback(std::move(feedback));
  (void)feedback_->write(message);
}

template <class Action>
void ActionServer<Action>::succeed(const GoalId& id, Result result, Time now) {
  finish(id, GoalEvent::succeed, std::move(result), now);
}

template <class Action>
void ActionServer<Action>::abort(const GoalId& id, Result result, Time now) {
  finish(id, GoalEvent::abort, std::move(result), now);
}

template <class Action>
void ActionServer<Action>::canceled(const GoalId& id, Result result, Time now) {
  finish(id, GoalEvent::canceled, std::move(result), now);
}

template <class Action>
void ActionServer<Action>::answer(const CallId& call, std::optional<std::int64_t> accepted_ns) {
  typename SendGoal::Response response;
  response.accepted(accepted_ns.has_value());
  if (accepted_ns) response.stamp(ros_stamp(*accepted_ns));
  send_goal_.reply(call, std::move(response));
}

template <class Action>
void ActionServer<Action>::serve_results() {
  constexpr std::size_t most_waiting = 64;
  while (const auto call = get_result_.take()) {
    const GoalId& id = call->request->goal_id().uuid();
    const GoalState where = state(id);
    if (where == GoalState::unknown) {
      const auto why = std::find_if(rejected_.begin(), rejected_.end(),
                                    [&](const auto& one) { return one.first == id; });
      reply(call->id, where, why != rejected_.end() ? why->second : Result());
      continue;
    }
    Ending& ending = results_[id];
    if (ending.result) {
      reply(call->id, where, *ending.result);
      continue;
    }
    if (ending.waiting.size() == most_waiting) ending.waiting.pop_front();
    ending.waiting.push_back(call->id);
  }
}

template <class Action>
void ActionServer<Action>::finish(const GoalId& id, GoalEvent event, Result result, Time now) {
  apply(id, event, now);
  Ending& ending = results_[id];
  for (const CallId& call : ending.waiting) reply(call, state(id), result);
  ending = {std::move(result), {}};
}

template <class Action>
void ActionServer<Action>::reply(const CallId& call, GoalState where, Result result) {
  typename GetResult::Response response;
  response.status(static_cast<std::int8_t>(where));
  response.result(std::move(result));
  get_result_.reply(call, std::move(response));
}

template <class Action>
ActionClient<Action>::ActionClient(Component& owner)
    : ids_(owner),
      send_goal_(owner, action_end(Action::name, "send_goal"), owner.node()),
      get_result_(owner, action_end(Action::name, "get_result"), owner.node()),
      cancel_(owner, action_end(Action::name, "cancel_goal"), owner.node()),
      feedback_(owner, {action_topic(Action::name, "feedback", "event"),
                        &type_info<typename Action::FeedbackMessage>(), Writers::optional}) {}

template <class Action>
bool ActionClient<Action>::available() const {
  return send_goal_.available() && get_result_.available() && cancel_.available();
}

template <class Action>
GoalId ActionClient<Action>::send(Goal goal, Time answer_by, Time result_by) {
  const GoalId id = ids_.next();
  typename SendGoal::Request request;
  request.goal_id().uuid(id);
  request.goal(std::move(goal));
  sent_[send_goal_.call(std::move(request), answer_by)] = {id, result_by};
  return id;
}

template <class Action>
void ActionClient<Action>::cancel(const GoalId& id, Time answer_by) {
  CancelGoal::Request request;
  request.goal_info().goal_id().uuid(id);
  cancels_[cancel_.call(std::move(request), answer_by)] = id;
}

template <class Action>
std::optional<typename ActionClient<Action>::News> ActionClient<Action>::take(Time now) {
  if (auto news = take_answer(now)) return news;
  if (auto news = take_cancel(now)) return news;
  if (auto news = take_feedback()) return news;
  return take_result(now);
}

template <class Action>
std::optional<typename ActionClient<Action>::News> ActionClient<Action>::take_answer(Time now) {
  const auto outcome = send_goal_.take(now);
  if (!outcome) return std::nullopt;
  const Sent sent = sent_.extract(outcome->call).mapped();
  if (!outcome->response) return News{sent.id, What::unanswered};
  if (!outcome->response->accepted()) {
    rejected_[ask_result(sent.id, now + reason_wait)] = sent.id;
    return std::nullopt;
  }
  running_[ask_result(sent.id, sent.result_by)] = sent.id;
  return News{sent.id, What::accepted};
}

template <class Action>
CallNumber ActionClient<Action>::ask_result(const GoalId& id, Time result_by) {
  typename GetResult::Request request;
  request.goal_id().uuid(id);
  return get_result_.call(std::move(request), result_by);
}

template <class Action>
std::optional<typename ActionClient<Action>::News> ActionClient<Action>::take_cancel(Time now) {
  const auto outcome = cancel_.take(now);
  if (!outcome) return std::nullopt;
  const GoalId id = cancels_.extract(outcome->call).mapped();
  const bool ends = outcome->response && !outcome->response->goals_canceling().empty();
  return News{id, ends ? What::canceling : What::not_ended};
}

template <class Action>
std::optional<typename ActionClient<Action>::News> ActionClient<Action>::take_feedback() {
  while (const auto taken = feedback_.take_message()) {
    const auto message = std::static_pointer_cast<const typename Action::FeedbackMessage>(taken);
    for (const auto& [call, id] : running_) {
      if (id != message->goal_id().uuid()) continue;
      return News{id, What::feedback, GoalState::executing, {message, &message->feedback()}};
    }
  }
  return std::nullopt;
}

template <class Action>
std::optional<typename ActionClient<Action>::News> ActionClient<Action>::take_result(Time now) {
  const auto outcome = get_result_.take(now);
  if (!outcome) return std::nullopt;
  if (const auto rejected = rejected_.extract(outcome->call)) {
    News news{rejected.mapped(), What::rejected};
    if (outcome->response) news.result = {outcome->response, &outcome->response->result()};
    return news;
  }
  const GoalId id = running_.extract(outcome->call).mapped();
  if (!outcome->response) return News{id, What::unanswered};
  const auto where = static_cast<GoalState>(outcome->response->status());
  return News{id, What::result, where, {}, {outcome->response, &outcome->response->result()}};
}

}  // namespace tocsin
