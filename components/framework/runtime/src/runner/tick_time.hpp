// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/time.hpp"

namespace tocsin {

/// The time of the tick that this thread is in. What a tick writes is written at that instant, as
/// in a simulation; so a write costs no reading of the clock.
class TickTime {
 public:
  explicit TickTime(Time now) { now_ = now; }
  ~TickTime() { now_ = never; }
  TickTime(const TickTime&) = delete;
  TickTime& operator=(const TickTime&) = delete;

  /// `never` outside of a tick.
  [[nodiscard]] static Time now() { return now_; }

 private:
  inline static thread_local Time now_ = never;
};

}  // namespace tocsin
