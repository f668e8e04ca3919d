// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/time.hpp"

namespace tocsin {

/// When a packet that may have been lost is sent again: after a pause, and a few times more, each
/// pause twice as long.
class RepeatTimes {
 public:
  static constexpr Duration first_pause = std::chrono::milliseconds(50);
  static constexpr int most_repeats = 5;

  explicit RepeatTimes(Time sent) : next_(sent + first_pause) {}

  [[nodiscard]] Time next() const { return next_; }
  /// It is sent again at `now`. False: for the last time.
  [[nodiscard]] bool repeat(Time now) {
    pause_ *= 2;
    next_ = now + pause_;
    return --left_ > 0;
  }

 private:
  Duration pause_ = first_pause;
  Time next_;
  int left_ = most_repeats;
};

}  // namespace tocsin
