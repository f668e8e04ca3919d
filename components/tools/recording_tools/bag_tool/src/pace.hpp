// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "foundation/time.hpp"

namespace tocsin::bag_tool {

/// [ns] The recorded time `s` [s] after another; the last one that there is when that is too far.
[[nodiscard]] std::int64_t later(std::int64_t from_ns, double s);

/// When a recorded message is due again, and which time of the recording it is.
///
/// Pure: `now` is handed in.
class Pace {
 public:
  /// The recorded time `first_ns` comes at `begin`. `rate`: 2 is twice as fast; above 0.
  Pace(double rate, std::int64_t first_ns, Time begin)
      : rate_(rate), first_ns_(first_ns), begin_(begin) {}

  /// Not before `begin`. What lies further than 290 years ahead is due at the end of the clock.
  [[nodiscard]] Time due(std::int64_t log_time_ns) const;
  /// [ns] The recorded time at `now`.
  [[nodiscard]] std::int64_t recorded_time_ns(Time now) const;

 private:
  double rate_;
  std::int64_t first_ns_;
  Time begin_;
};

}  // namespace tocsin::bag_tool
