// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "graph.hpp"
#include "poor_place.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::check {

/// Warns of reliable link topics whose writers expect to write more than the radio carries in a
/// poor place, once for each reading process on another host: what is repaired then takes the
/// place of everything else. Writers that do not tell what they expect are not judged.
[[nodiscard]] std::vector<Finding> examine_load(const Graph& graph, const QosProfiles& qos,
                                                const PoorPlace& place);

}  // namespace tocsin::check
