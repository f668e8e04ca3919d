// SPDX-License-Identifier: Apache-2.0
#include "link/flow_qos.hpp"

#include <algorithm>

#include "link/flow_text.hpp"

namespace tocsin {
namespace {

constexpr int burst_depth = 32;

}  // namespace

QosProfile offered(const Flow& flow) {
  QosProfile profile;
  profile.reliability = flow.reliable ? Reliability::reliable : Reliability::best_effort;
  profile.durability =
      flow.transient_local ? Durability::transient_local : Durability::volatile_kind;
  // What came in one burst is not pushed out before the readers have it; who comes late gets no
  // more of a state than its writer keeps.
  profile.depth = flow.transient_local ? flow.depth : std::max(flow.depth, burst_depth);
  profile.lifespan_s = flow.lifespan_s;
  // A reader that had forgotten us learns by a heartbeat from which sample on it hears, and Fast
  // DDS sends none when the unacknowledged sample has outlived its lifespan.
  profile.heartbeat_period_s = std::clamp(flow.lifespan_s / 4, 0.01, 0.1);
  profile.user_data = flow.user_data;
  return profile;
}

QosProfile offered_on_link(const Flow& flow) {
  QosProfile profile;
  profile.reliability = Reliability::best_effort;
  profile.publish_mode = PublishMode::synchronous;
  profile.user_data = announcement_of(flow);
  return profile;
}

}  // namespace tocsin
