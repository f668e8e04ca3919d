// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "navigation/mission.hpp"

namespace tocsin {

/// A pose to drive to, those that follow it, and until when all of them may be driven to.
struct Goal {
  static constexpr std::size_t most_ahead = 32;

  std::uint64_t mission = 0;  // that it belongs to; see GoalList
  std::uint64_t id = 0;       // a greater one of the same mission supersedes; 0 is none
  navigation::Waypoint pose;
  double tolerance_m = 0.2;  // [range 0.05,5] arrived when nearer than this
  Time expires;
  std::vector<navigation::Waypoint> ahead;  // the k-th of them, from 1, is goal `id` + k
};

enum class GoalAnswer {
  accepted,
  renewed,     // the goal that it has already, or one before it: later expiry, new list ahead
  superseded,  // older than the newest goal, or of a mission before this one: refused
  expired,     // refused
  invalid,     // not finite, no id, more ahead than there are ids or room for, or a tolerance or a
               // time out of range: refused
};

/// The goals of the vehicle, driven to one after the other under one lease. So a vehicle that
/// reaches a goal where it hears nothing still knows the next one, and drives until the lease is
/// over.
///
/// Ids are compared within a mission only. A mission that was not seen before takes over with its
/// first goal, and the one before it is over: what still comes of it is refused, however large its
/// ids are. So a goal that somebody else sent, or whose numbers were damaged, is superseded by
/// whoever begins a mission of its own, as mission control does then. The last 16 missions are
/// remembered.
///
/// Pure: no clock.
class GoalList {
 public:
  [[nodiscard]] GoalAnswer on_goal(Goal goal, Time now);
  /// Makes the next goal the present one. False when there is none.
  bool advance();
  /// The present goal and those ahead are driven to no more; those that come are.
  void expire(Time now);
  /// What to drive to now; empty before the first goal.
  [[nodiscard]] const std::optional<Goal>& present() const { return goal_; }
  /// Differs from that of every present goal before; 0 when there is none.
  [[nodiscard]] std::uint64_t present_number() const { return number_; }

 private:
  static constexpr std::size_t remembered = 16;
  [[nodiscard]] bool is_over(std::uint64_t mission) const;
  void take_up(Goal goal);
  std::optional<Goal> goal_;
  std::uint64_t number_ = 0;
  std::deque<std::uint64_t> over_;  // missions before this one
};

[[nodiscard]] const char* to_string(GoalAnswer answer);

}  // namespace tocsin
