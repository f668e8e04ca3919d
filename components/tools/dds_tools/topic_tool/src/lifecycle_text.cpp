// SPDX-License-Identifier: Apache-2.0
#include "lifecycle_text.hpp"

#include <fmt/format.h>

#include "foundation/printable.hpp"

namespace tocsin::topic_tool {
namespace {

/// Of a state and of a transition alike.
template <class Named>
std::string named_text(const Named& one) {
  return fmt::format("{} [{}]", printable(one.label()), one.id());
}

}  // namespace

std::string state_text(const lifecycle_msgs::msg::State& state) { return named_text(state); }

std::string transitions_text(const Transitions& transitions) {
  std::string text;
  for (const auto& one : transitions) {
    text += fmt::format("- {}\n\tStart: {}\n\tGoal: {}\n", named_text(one.transition()),
                        printable(one.start_state().label()), printable(one.goal_state().label()));
  }
  return text;
}

std::optional<lifecycle_msgs::msg::Transition> chosen(const Transitions& transitions,
                                                      const std::string& word) {
  for (const auto& one : transitions) {
    const auto& transition = one.transition();
    if (transition.label() == word || std::to_string(transition.id()) == word) return transition;
  }
  return std::nullopt;
}

std::string unknown_text(const Transitions& transitions) {
  std::string text = "Unknown transition requested, available ones are:";
  for (const auto& one : transitions) text += "\n- " + named_text(one.transition());
  return text + "\n";
}

}  // namespace tocsin::topic_tool
