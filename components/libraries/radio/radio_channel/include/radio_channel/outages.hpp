// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin::radio {

/// Intervals in which nothing is received.
class Outages {
 public:
  /// `script_s` holds begin and length of each interval, in seconds after `start`, in order and
  /// without overlap; throws ConfigError otherwise.
  Outages(const std::vector<double>& script_s, Time start);
  /// Adds an interval from now on; the later end of two counts.
  void begin(Time now, Duration length);
  /// `now` may go back.
  [[nodiscard]] bool active(Time now) const {
    return manual_.holds(now) ||
           std::any_of(script_.begin(), script_.end(),
                       [now](const Interval& interval) { return interval.holds(now); });
  }

 private:
  struct Interval {
    Time from;
    Time until;
    [[nodiscard]] bool holds(Time now) const { return now >= from && now < until; }
  };
  std::vector<Interval> script_;
  Interval manual_{Time::min(), Time::min()};
};

}  // namespace tocsin::radio
