// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph.hpp"
#include "poor_place.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin::check {

/// Warns of link topics above class low whose writers expect to write more than the radio carries
/// in a poor place, once for each other host: the classes below wait for ever there. Adaptive ones
/// follow the link, and writers that do not tell what they expect are not judged. `rules`: by role.
[[nodiscard]] std::vector<Finding> examine_load(const Graph& graph, const QosProfiles& qos,
                                                const std::map<Role, TrafficRules>& rules,
                                                const PoorPlace& place);

}  // namespace tocsin::check
