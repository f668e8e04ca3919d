// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  [[nodiscard]] bool active(Time now) const;

 private:
  struct Interval {
    Time from;
    Time until;
  };
  std::vector<Interval> script_;
  Interval manual_{Time::min(), Time::min()};
};

}  // namespace tocsin::radio
