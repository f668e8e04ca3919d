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
    const double since_s = std::max(0.0, to_seconds(now - at_));
    const double left = std::max(0.0, rate.burst - used_ + since_s * rate.per_s);
    at_ = now;
    used_ = rate.burst - std::min(left, rate.burst);
    if (amount > rate.burst - used_) return false;
    used_ += amount;
    return true;
  }

 private:
  double used_ = 0;
  Time at_{};
};

}  // namespace tocsin::rtps_filter
