// SPDX-License-Identifier: Apache-2.0
// The lifecycle of a component in the messages of ROS 2. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "container/lifecycle.hpp"
#include "ros_idl/lifecycle_msgs.hpp"

namespace tocsin {

using RosState = lifecycle_msgs::msg::State;
using RosTransition = lifecycle_msgs::msg::Transition;

/// The number and label of rcl_lifecycle. A component that threw is `errorprocessing`, until
/// somebody cleans it up or shuts it down.
[[nodiscard]] RosState ros_state(LifecycleState state);
/// All that rcl_lifecycle knows, those in between among them.
[[nodiscard]] std::vector<RosState> ros_states();

/// What leads out of a state, each to the state in between, as rcl_lifecycle has it.
[[nodiscard]] std::vector<lifecycle_msgs::msg::TransitionDescription> ros_transitions(
    LifecycleState from);
/// Those out of all states, and those out of the states in between.
[[nodiscard]] std::vector<lifecycle_msgs::msg::TransitionDescription> ros_transition_graph();

/// Which transition is asked for: by its label, or, where that is empty, by its number. Nothing
/// when there is none of this name that may be asked for from `from`.
[[nodiscard]] std::optional<Transition> asked_transition(const RosTransition& asked,
                                                         LifecycleState from);

/// What rcl_lifecycle tells of a change: the way into the state in between, and out of it. Empty
/// where nothing leads from one to the other.
[[nodiscard]] std::vector<lifecycle_msgs::msg::TransitionEvent> transition_events(
    LifecycleState before, LifecycleState after, std::uint64_t wall_ns);

}  // namespace tocsin
