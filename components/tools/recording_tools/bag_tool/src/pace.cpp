// SPDX-License-Identifier: Apache-2.0
#include "pace.hpp"

#include <algorithm>
#include <limits>

namespace tocsin::bag_tool {

std::int64_t later(std::int64_t from_ns, double s) {
  const std::int64_t room = std::numeric_limits<std::int64_t>::max() - from_ns;
  return from_ns + std::min(seconds(s).count(), room);
}

Time Pace::due(std::int64_t log_time_ns) const {
  if (log_time_ns <= first_ns_) return begin_;
  const double after_s = static_cast<double>(log_time_ns - first_ns_) * 1e-9 / rate_;
  const Duration room = Time::max() - begin_;
  return begin_ + std::min(seconds(after_s), room);
}

std::int64_t Pace::recorded_time_ns(Time now) const {
  const double after_ns = to_seconds(std::max(now, begin_) - begin_) * rate_ * 1e9;
  constexpr double most = 9e18;
  return first_ns_ +
         static_cast<std::int64_t>(std::min(after_ns, most - static_cast<double>(first_ns_)));
}

}  // namespace tocsin::bag_tool
