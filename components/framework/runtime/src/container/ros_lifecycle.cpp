// SPDX-License-Identifier: Apache-2.0
#include "container/ros_lifecycle.hpp"

#include <array>

namespace tocsin {
namespace {

using Description = lifecycle_msgs::msg::TransitionDescription;
using Event = lifecycle_msgs::msg::TransitionEvent;
using State = LifecycleState;
namespace state_id = lifecycle_msgs::msg::State_Constants;
namespace transition_id = lifecycle_msgs::msg::Transition_Constants;

/// A state by its number in lifecycle_msgs.
struct Named {
  std::uint8_t id;
  const char* label;
};

/// rcl_lifecycle, default_state_machine.c.
constexpr std::array states{
    Named{state_id::PRIMARY_STATE_UNKNOWN, "unknown"},
    Named{state_id::PRIMARY_STATE_UNCONFIGURED, "unconfigured"},
    Named{state_id::PRIMARY_STATE_INACTIVE, "inactive"},
    Named{state_id::PRIMARY_STATE_ACTIVE, "active"},
    Named{state_id::PRIMARY_STATE_FINALIZED, "finalized"},
    Named{state_id::TRANSITION_STATE_CONFIGURING, "configuring"},
    Named{state_id::TRANSITION_STATE_CLEANINGUP, "cleaningup"},
    Named{state_id::TRANSITION_STATE_SHUTTINGDOWN, "shuttingdown"},
    Named{state_id::TRANSITION_STATE_ACTIVATING, "activating"},
    Named{state_id::TRANSITION_STATE_DEACTIVATING, "deactivating"},
    Named{state_id::TRANSITION_STATE_ERRORPROCESSING, "errorprocessing"},
};

/// What may be asked for, as rcl_lifecycle numbers it, and the state in between. Its end is that of
/// lifecycle.cpp.
struct Way {
  State from;
  Transition transition;
  std::uint8_t id;
  std::uint8_t between;
};

constexpr std::array ways{
    Way{State::unconfigured, Transition::configure, transition_id::TRANSITION_CONFIGURE,
        state_id::TRANSITION_STATE_CONFIGURING},
    Way{State::unconfigured, Transition::shutdown, transition_id::TRANSITION_UNCONFIGURED_SHUTDOWN,
        state_id::TRANSITION_STATE_SHUTTINGDOWN},
    Way{State::inactive, Transition::cleanup, transition_id::TRANSITION_CLEANUP,
        state_id::TRANSITION_STATE_CLEANINGUP},
    Way{State::inactive, Transition::activate, transition_id::TRANSITION_ACTIVATE,
        state_id::TRANSITION_STATE_ACTIVATING},
    Way{State::inactive, Transition::shutdown, transition_id::TRANSITION_INACTIVE_SHUTDOWN,
        state_id::TRANSITION_STATE_SHUTTINGDOWN},
    Way{State::active, Transition::deactivate, transition_id::TRANSITION_DEACTIVATE,
        state_id::TRANSITION_STATE_DEACTIVATING},
    Way{State::active, Transition::shutdown, transition_id::TRANSITION_ACTIVE_SHUTDOWN,
        state_id::TRANSITION_STATE_SHUTTINGDOWN},
    // rcl_lifecycle leaves errorprocessing by itself; here a person does.
    Way{State::error, Transition::cleanup, transition_id::TRANSITION_CLEANUP,
        state_id::TRANSITION_STATE_CLEANINGUP},
    Way{State::error, Transition::shutdown, transition_id::TRANSITION_INACTIVE_SHUTDOWN,
        state_id::TRANSITION_STATE_SHUTTINGDOWN},
};

RosState named(std::uint8_t id) {
  RosState state;
  for (const Named& one : states) {
    if (one.id != id) continue;
    state.id(id);
    state.label(one.label);
  }
  return state;
}

RosTransition transition_of(std::uint8_t id, const char* label) {
  RosTransition transition;
  transition.id(id);
  transition.label(label);
  return transition;
}

/// Numbers of the ways out of a state in between: ten for each, in the order of these states.
std::uint8_t number_of_success(std::uint8_t between) {
  switch (between) {
    case state_id::TRANSITION_STATE_CONFIGURING:
      return 10;
    case state_id::TRANSITION_STATE_CLEANINGUP:
      return 20;
    case state_id::TRANSITION_STATE_ACTIVATING:
      return 30;
    case state_id::TRANSITION_STATE_DEACTIVATING:
      return 40;
    default:
      return 50;  // shutting down
  }
}
constexpr std::uint8_t error_after_success = 2;  // TRANSITION_ON_CONFIGURE_ERROR is 12, and so on

Description described(const RosTransition& transition, const RosState& from, const RosState& to) {
  Description description;
  description.transition(transition);
  description.start_state(from);
  description.goal_state(to);
  return description;
}

Description into(const Way& way) {
  return described(transition_of(way.id, to_text(way.transition)), ros_state(way.from),
                   named(way.between));
}

Description out_of(const Way& way) {
  const State end = after(way.from, way.transition).value();
  return described(transition_of(number_of_success(way.between), "transition_success"),
                   named(way.between), ros_state(end));
}

Event event_of(const Description& description, std::uint64_t wall_ns) {
  Event event;
  event.timestamp(wall_ns);
  event.transition(description.transition());
  event.start_state(description.start_state());
  event.goal_state(description.goal_state());
  return event;
}

/// It threw: while it was made, or in a tick.
std::vector<Event> error_events(State before, std::uint64_t wall_ns) {
  const bool was_made = before == State::unconfigured;
  const RosState from =
      was_made ? named(state_id::TRANSITION_STATE_CONFIGURING) : ros_state(before);
  const auto id = static_cast<std::uint8_t>(
      number_of_success(state_id::TRANSITION_STATE_CONFIGURING) + error_after_success);
  return {event_of(described(transition_of(id, "transition_error"), from, ros_state(State::error)),
                   wall_ns)};
}

}  // namespace

RosState ros_state(LifecycleState state) {
  switch (state) {
    case State::unconfigured:
      return named(state_id::PRIMARY_STATE_UNCONFIGURED);
    case State::inactive:
      return named(state_id::PRIMARY_STATE_INACTIVE);
    case State::active:
      return named(state_id::PRIMARY_STATE_ACTIVE);
    case State::finalized:
      return named(state_id::PRIMARY_STATE_FINALIZED);
    case State::error:
      return named(state_id::TRANSITION_STATE_ERRORPROCESSING);
  }
  return named(state_id::PRIMARY_STATE_UNKNOWN);
}

std::vector<RosState> ros_states() {
  std::vector<RosState> all;
  for (const Named& one : states) all.push_back(named(one.id));
  return all;
}

std::vector<Description> ros_transitions(LifecycleState from) {
  std::vector<Description> all;
  for (const Way& way : ways) {
    if (way.from == from) all.push_back(into(way));
  }
  return all;
}

std::vector<Description> ros_transition_graph() {
  std::vector<Description> all;
  for (const Way& way : ways) all.push_back(into(way));
  for (const Way& way : ways) all.push_back(out_of(way));
  return all;
}

std::optional<Transition> asked_transition(const RosTransition& asked, LifecycleState from) {
  for (const Way& way : ways) {
    if (way.from != from) continue;
    const bool is_it =
        asked.label().empty() ? asked.id() == way.id : asked.label() == to_text(way.transition);
    if (is_it) return way.transition;
  }
  return std::nullopt;
}

std::vector<Event> transition_events(LifecycleState before, LifecycleState after_it,
                                     std::uint64_t wall_ns) {
  if (after_it == State::error && before != State::error) return error_events(before, wall_ns);
  for (const Way& way : ways) {
    if (way.from != before || after(before, way.transition) != after_it) continue;
    return {event_of(into(way), wall_ns), event_of(out_of(way), wall_ns)};
  }
  return {};
}

}  // namespace tocsin
