// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "digest.hpp"
#include "event_queue.hpp"
#include "simulation/observer.hpp"

namespace tocsin::simulation {

/// Virtual time starts at one hour, wall time at 2026-01-01 00:00 UTC, as in SimBus.
inline constexpr Time start_time = Time{std::chrono::hours(1)};
inline constexpr std::int64_t start_wall_ns = 1'767'225'600'000'000'000;

/// What all parts of one simulation share. One thread.
struct Core {
  Time now = start_time;
  EventQueue events;
  Digest digest;
  std::uint64_t samples = 0;
  bool dying = false;  ///< a process is being killed: what its components still do is void
  bool digest_wanted = true;
  std::vector<Observer*> observers = {nullptr};  ///< by vehicle; null: nobody looks

  [[nodiscard]] Observer* observer(std::size_t vehicle) const { return observers[vehicle]; }

  [[nodiscard]] static std::int64_t wall_ns(Time t) {
    return start_wall_ns + (t - start_time).count();
  }
};

}  // namespace tocsin::simulation
