// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/time.hpp"

namespace tocsin::router {

/// Decides whether the gate of one role is open.
///
/// It follows the role's transmission state, and opens by itself when that state falls silent: a
/// dead controller must not keep a vehicle mute. Pure.
class GateKeeper {
 public:
  /// Without a state for longer than this the gate opens: the controller publishes each second.
  static constexpr Duration silence_limit = std::chrono::seconds(5);

  /// A state of this role, received at `now`.
  void on_state(bool active, Time now);
  [[nodiscard]] bool open(Time now) const;
  /// When `open` will change without a further state.
  [[nodiscard]] Time deadline(Time now) const;

 private:
  bool active_ = true;
  Time received_{};
};

}  // namespace tocsin::router
