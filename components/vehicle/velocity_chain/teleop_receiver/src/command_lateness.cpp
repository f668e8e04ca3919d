// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/command_lateness.hpp"

#include <algorithm>

namespace tocsin {

bool CommandLateness::is_fresh(std::int64_t sent_ns, std::int64_t received_ns) {
  if (received_ns >= window_end_ns_) {
    const bool has_run = quickest_ns_ != none && received_ns - window_end_ns_ < window_ns;
    quickest_before_ns_ = has_run ? quickest_ns_ : none;
    quickest_ns_ = none;
    window_end_ns_ = received_ns + window_ns;
  }
  const std::int64_t delay_ns = received_ns - sent_ns;
  quickest_ns_ = std::min(quickest_ns_, delay_ns);
  return delay_ns - std::min(quickest_ns_, quickest_before_ns_) <= lifespan_ns_;
}

}  // namespace tocsin
