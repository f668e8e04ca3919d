// SPDX-License-Identifier: Apache-2.0
#include "container/lifecycle.hpp"

#include <array>

namespace tocsin {
namespace {

using State = LifecycleState;

struct Rule {
  State from;
  Transition transition;
  State to;
};

constexpr std::array rules{
    Rule{State::unconfigured, Transition::configure, State::inactive},
    Rule{State::inactive, Transition::activate, State::active},
    Rule{State::active, Transition::deactivate, State::inactive},
    Rule{State::inactive, Transition::cleanup, State::unconfigured},
    Rule{State::error, Transition::cleanup, State::unconfigured},
    Rule{State::unconfigured, Transition::shutdown, State::finalized},
    Rule{State::inactive, Transition::shutdown, State::finalized},
    Rule{State::active, Transition::shutdown, State::finalized},
    Rule{State::error, Transition::shutdown, State::finalized},
};

constexpr std::array transitions{Transition::configure, Transition::activate,
                                 Transition::deactivate, Transition::cleanup, Transition::shutdown};

}  // namespace

std::optional<State> after(State state, Transition transition) {
  for (const Rule& rule : rules) {
    if (rule.from == state && rule.transition == transition) return rule.to;
  }
  return std::nullopt;
}

const char* to_text(State state) {
  constexpr std::array names{"unconfigured", "inactive", "active", "finalized", "error"};
  return names[static_cast<std::size_t>(state)];
}

const char* to_text(Transition transition) {
  constexpr std::array names{"configure", "activate", "deactivate", "cleanup", "shutdown"};
  return names[static_cast<std::size_t>(transition)];
}

std::optional<Transition> to_transition(const std::string& word) {
  for (const Transition one : transitions) {
    if (word == to_text(one)) return one;
  }
  return std::nullopt;
}

}  // namespace tocsin
