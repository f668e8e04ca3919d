// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin::check {

/// What holds for all nodes of a graph.
struct Rules {
  const QosProfiles& qos;
  const std::map<Role, TrafficRules>& traffic;  ///< by role
  std::vector<std::string> topics;              ///< that the installed packages know
  bool has_far_end = false;  ///< whether hosts that the graph lacks are on the link
};

/// What is wrong with a graph, in the order of its nodes:
/// - error: a topic with two types or two scopes, a pair of ends whose QoS will not match (policy
///   by policy), a missing profile, a link topic without a traffic class or whose writers would
///   have owners;
/// - warning: a reader that needs a writer and has none, where none can be at a far end, or only
///   writers where the topic's scope does not reach; a QoS override for a topic that nobody has; a
///   traffic rule for a topic that nobody knows and that is spelt almost like one;
/// - note: a reader that does without a writer, a writer without a reader, a traffic rule for a
///   topic that nobody writes.
[[nodiscard]] std::vector<Finding> examine(const Graph& graph, const Rules& rules);

}  // namespace tocsin::check
