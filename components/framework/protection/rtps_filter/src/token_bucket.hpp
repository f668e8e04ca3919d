// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "foundation/time.hpp"
#include "rtps_filter/limits.hpp"

namespace tocsin::rtps_filter {

/// How much of a Rate is left; full at first.
class TokenBucket {
 public:
  /// Takes `amount`, or nothing when less is left.
  [[nodiscard]] bool take(double amount, const Rate& rate, Time now) {
    refill(rate, now);
    if (amount > rate.burst - used_) return false;
    used_ += amount;
    return true;
  }
  /// Takes `amount`, and owes what is not there; gives it back where it is negative.
  void spend(double amount, const Rate& rate, Time now) {
    refill(rate, now);
    used_ = std::max(0.0, used_ + amount);
  }
  [[nodiscard]] bool is_empty(const Rate& rate, Time now) {
    refill(rate, now);
    return used_ >= rate.burst;
  }

 private:
  void refill(const Rate& rate, Time now) {
    const double since_s = std::max(0.0, to_seconds(now - at_));
    used_ = std::max(0.0, used_ - since_s * rate.per_s);
    at_ = now;
  }

  double used_ = 0;
  Time at_{};
};

}  // namespace tocsin::rtps_filter
