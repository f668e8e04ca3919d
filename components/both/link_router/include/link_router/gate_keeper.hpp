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
  /// `silence_limit`: without a state for longer than this the gate opens.
  explicit GateKeeper(Duration silence_limit) : silence_limit_(silence_limit) {}

  /// A state of this role, received at `now`.
  void on_state(bool active, Time now);
  [[nodiscard]] bool open(Time now) const;
  /// When `open` will change without a further state.
  [[nodiscard]] Time deadline(Time now) const;

 private:
  Duration silence_limit_;
  bool active_ = true;
  Time heard_{};
};

}  // namespace tocsin::router
