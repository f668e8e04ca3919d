// SPDX-License-Identifier: Apache-2.0
#include "container/lifecycle_services.hpp"

#include <utility>

#include "idl_support/topic_registry.hpp"

namespace tocsin {
namespace {

using Event = lifecycle_msgs::msg::TransitionEvent;

Endpoint event_end(const std::string& node) {
  return {make_topic_info(node + "/transition_event", "event", Scope::host), &type_info<Event>(),
          Writers::needed, "", node};
}

}  // namespace

LifecycleServices::LifecycleServices(Component& owner, const std::string& node,
                                     LifecycleState state)
    : owner_(owner),
      told_(state),
      change_(owner, lifecycle_service::ChangeState::name, node),
      state_(owner, lifecycle_service::GetState::name, node),
      states_(owner, lifecycle_service::GetAvailableStates::name, node),
      transitions_(owner, lifecycle_service::GetAvailableTransitions::name, node),
      graph_(owner, lifecycle_service::GetTransitionGraph::name, node),
      events_(owner.bus().advertise(event_end(node))) {}

void LifecycleServices::answer(const LifecycleSource& source) {
  while (const auto call = change_.take()) {
    const auto wanted = asked_transition(call->request->transition(), source.state());
    lifecycle_service::ChangeState::Response response;
    response.success(wanted && source.change(*wanted).done);
    change_.reply(call->id, response);
    tell(source.state());
  }
  tell(source.state());
  answer_readers(source.state());
}

void LifecycleServices::answer_readers(LifecycleState state) {
  while (const auto call = state_.take()) {
    lifecycle_service::GetState::Response response;
    response.current_state(ros_state(state));
    state_.reply(call->id, std::move(response));
  }
  while (const auto call = states_.take()) {
    lifecycle_service::GetAvailableStates::Response response;
    response.available_states(ros_states());
    states_.reply(call->id, std::move(response));
  }
  while (const auto call = transitions_.take()) {
    lifecycle_service::GetAvailableTransitions::Response response;
    response.available_transitions(ros_transitions(state));
    transitions_.reply(call->id, std::move(response));
  }
  while (const auto call = graph_.take()) {
    lifecycle_service::GetTransitionGraph::Response response;
    response.available_transitions(ros_transition_graph());
    graph_.reply(call->id, std::move(response));
  }
}

void LifecycleServices::tell(LifecycleState state) {
  if (state == told_) return;
  const auto wall_ns = static_cast<std::uint64_t>(owner_.bus().wall_ns(owner_.bus().now()));
  for (Event& event : transition_events(std::exchange(told_, state), state, wall_ns)) {
    (void)events_->write(std::make_shared<const Event>(std::move(event)));  // the state stays true
  }
}

}  // namespace tocsin
