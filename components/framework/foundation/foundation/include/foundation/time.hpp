// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cmath>

namespace tocsin {

/// Nanoseconds; the only duration of the stack. Files and messages use seconds with the suffix _s.
using Duration = std::chrono::nanoseconds;

/// A point on the monotonic clock, or on the virtual clock of a simulation. Never wall time.
using Time = std::chrono::time_point<std::chrono::steady_clock, Duration>;

/// Later than every event: the deadline of something that waits for input only.
inline constexpr Time never = Time::max();

/// `s` seconds, rounded to the nanosecond. Beyond about +-290 years the result saturates.
[[nodiscard]] inline Duration seconds(double s) {
  constexpr double limit_s = 9.2e9;
  if (s >= limit_s) return Duration::max();
  if (s <= -limit_s) return Duration::min();
  return Duration{std::llround(s * 1e9)};
}

[[nodiscard]] inline double to_seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}

/// Seconds since the clock's own epoch.
[[nodiscard]] inline double to_seconds(Time t) { return to_seconds(t.time_since_epoch()); }

}  // namespace tocsin
