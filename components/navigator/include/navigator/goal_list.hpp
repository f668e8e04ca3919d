// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "navigation/geometry.hpp"

namespace tocsin {

/// A pose to drive to, those that follow it, and until when all of them may be driven to.
struct Goal {
  static constexpr std::size_t most_ahead = 32;

  std::uint64_t id = 0;  // a greater one supersedes; 0 is none
  navigation::Pose2 pose;
  double tolerance_m = 0.2;  // [range 0.05,5] arrived when nearer than this
  Time expires;
  std::vector<navigation::Pose2> ahead;  // the k-th of them, from 1, is goal `id` + k
};

enum class GoalAnswer {
  accepted,
  renewed,     // the goal that it has already, or one before it: later expiry, new list ahead
  superseded,  // older than the newest goal, refused
  expired,     // refused
  invalid,     // not finite, no id, too many ahead, or a tolerance out of range: refused
};

/// The goals of the vehicle, driven to one after the other under one lease. So a vehicle that
/// reaches a goal where it hears nothing still knows the next one, and drives until the lease is
/// over.
///
/// Pure: no clock.
class GoalList {
 public:
  [[nodiscard]] GoalAnswer on_goal(Goal goal, Time now);
  /// Makes the next goal the present one. False when there is none.
  bool advance();
  /// What to drive to now; empty before the first goal.
  [[nodiscard]] const std::optional<Goal>& present() const { return goal_; }

 private:
  std::optional<Goal> goal_;
};

[[nodiscard]] const char* to_string(GoalAnswer answer);

}  // namespace tocsin
