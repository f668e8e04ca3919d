// SPDX-License-Identifier: Apache-2.0
// QoS between a host and a bag.
#pragma once

#include <vector>

#include "bag/offered_qos.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::bag_tool {

/// What the writers of a topic offer, each offer once.
[[nodiscard]] std::vector<bag::OfferedQos> offered_by(const std::vector<const GraphEnd*>& writers);

/// What a writer offers that stands for all recorded ones: of each policy the strongest offer, so
/// that every reader matches that matched one of them; the longest lifespan. Without a recorded
/// offer: reliable, volatile, the last 10.
[[nodiscard]] QosProfile writer_qos(const std::vector<bag::OfferedQos>& recorded);

}  // namespace tocsin::bag_tool
