// SPDX-License-Identifier: Apache-2.0
// A change of QoS of a topic that is in use, all over a host.
#pragma once

#include <string>
#include <vector>

#include "matches.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::qos_tool {

/// A YAML map of `policy=value`. Throws ConfigError for what is not of this form.
[[nodiscard]] std::string settings_map(const std::vector<std::string>& settings);

/// What the ends of a topic agree on now, for rules across policies. `ends` must not be empty.
[[nodiscard]] QosProfile announced_profile(const std::vector<End>& ends);

/// Who takes the change first, so that pairs which match go on matching: `writers` or `readers`.
/// A deadline that becomes longer must be requested before it is offered, one that becomes shorter
/// offered before it is requested. Throws ConfigError for what cannot change.
[[nodiscard]] std::vector<std::string> order_of(const std::vector<End>& writers,
                                                const std::string& settings);

/// The pairs that do not match.
[[nodiscard]] std::vector<Pair> stopped(const std::vector<Pair>& pairs);

}  // namespace tocsin::qos_tool
