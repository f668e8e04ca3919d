// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// Where a component stands; the names of ROS 2's primary states. `error` is entered when the
/// component throws, and left by cleanup or shutdown.
enum class LifecycleState {
  unconfigured,  ///< known, not constructed
  inactive,      ///< constructed; not ticked, its inputs get nothing
  active,        ///< ticked
  finalized,     ///< destroyed for good
  error,         ///< threw; not ticked, its inputs get nothing
};

enum class Transition { configure, activate, deactivate, cleanup, shutdown };

/// The state after the transition; empty when it is not allowed from `state`.
[[nodiscard]] std::optional<LifecycleState> after(LifecycleState state, Transition transition);

[[nodiscard]] const char* to_text(LifecycleState state);
[[nodiscard]] const char* to_text(Transition transition);
/// Empty for a word that is no transition.
[[nodiscard]] std::optional<Transition> to_transition(const std::string& word);

}  // namespace tocsin
