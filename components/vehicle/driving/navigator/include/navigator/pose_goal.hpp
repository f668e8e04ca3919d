// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "foundation/time.hpp"
#include "navigator/navigator.hpp"

namespace tocsin {

/// How the drive to a pose has ended.
enum class PoseGoalEnd {
  reached,
  canceled,    ///< the vehicle stands, as was asked
  timed_out,   ///< not reached in its time
  superseded,  ///< somebody else's goal is driven to
};
[[nodiscard]] const char* to_string(PoseGoalEnd end);

/// A goal that somebody on the vehicle has given, and what becomes of it. It is a mission of its
/// own. Pure.
class PoseGoal {
 public:
  PoseGoal(std::uint64_t mission, Time started, Time expires)
      : mission_(mission), started_(started), expires_(expires) {}

  /// Somebody wants it to end; it does when the vehicle stands.
  void cancel() { canceling_ = true; }
  [[nodiscard]] bool is_canceling() const { return canceling_; }
  /// How it has ended, by what the navigator does now; nothing: it has not.
  [[nodiscard]] std::optional<PoseGoalEnd> end(const Navigator::Output& output, Time now) const;
  [[nodiscard]] Time started() const { return started_; }

 private:
  std::uint64_t mission_;
  Time started_;
  Time expires_;
  bool canceling_ = false;
};

}  // namespace tocsin
