// SPDX-License-Identifier: Apache-2.0
// What `ros2 lifecycle` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ros_idl/lifecycle_msgs.hpp"

namespace tocsin::topic_tool {

using Transitions = std::vector<lifecycle_msgs::msg::TransitionDescription>;

/// "active [3]".
[[nodiscard]] std::string state_text(const lifecycle_msgs::msg::State& state);
/// Three lines each: name and number, where from, where to.
[[nodiscard]] std::string transitions_text(const Transitions& transitions);

/// The one that a person means by its label or its number; nothing when it is none of these.
[[nodiscard]] std::optional<lifecycle_msgs::msg::Transition> chosen(const Transitions& transitions,
                                                                    const std::string& word);
/// Names those that there are in place of `word`.
[[nodiscard]] std::string unknown_text(const Transitions& transitions);

}  // namespace tocsin::topic_tool
