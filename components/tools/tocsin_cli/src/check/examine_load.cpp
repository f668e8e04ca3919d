// SPDX-License-Identifier: Apache-2.0
#include "examine_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "foundation/error.hpp"
#include "link_router/wire_cost.hpp"

namespace tocsin::check {
namespace {

/// Each gets a copy.
std::size_t hosts_beside(const Graph& graph, const Node& writer) {
  std::set<std::string> hosts;
  for (const Node& node : graph) {
    if (node.host != writer.host) hosts.insert(node.host);
  }
  return hosts.size();
}

/// [byte/s] in IP packets to all hosts.
double offered(const ExpectedLoad& load, const QosProfile& qos, std::size_t hosts) {
  const auto cost = router::wire_cost(static_cast<std::size_t>(load.bytes));
  return std::min(load.rate_hz, qos.max_rate_hz) * static_cast<double>(cost.bytes * hosts);
}

/// Empty when the profile is missing, which is told elsewhere.
std::optional<QosProfile> profile_of(const Port& port, const QosProfiles& qos) {
  try {
    return qos.of(port.qos, port.topic);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

/// Of a topic that goes before others; empty for one that does not, or has no class.
std::optional<TrafficClass> class_above_low(const Node& node, const Port& port,
                                            const std::map<Role, TrafficRules>& rules) {
  const auto of_role = rules.find(node.role);
  if (of_role == rules.end()) return std::nullopt;
  const auto rule = of_role->second.all().find(port.topic);
  if (rule == of_role->second.all().end() || rule->second.adaptive) return std::nullopt;
  const TrafficClass found = rule->second.traffic_class;
  return found == TrafficClass::low ? std::nullopt : std::optional(found);
}

std::string warning(const Node& node, const Port& port, TrafficClass traffic_class,
                    double bytes_per_s, const PoorPlace& place) {
  return fmt::format(
      "topic {}: {} writes {:.0f} kB/s on the radio in class {}; in its poor places ({:.0f} dB) {} "
      "carries {:.0f} kB/s, so that the classes below wait there: put it into class low, or let "
      "its writer follow the budget (adaptive)",
      port.topic, node.path(), bytes_per_s / 1000, to_string(traffic_class), place.mean_snr_db,
      place.channel, place.bytes_per_s / 1000);
}

}  // namespace

std::vector<Finding> examine_load(const Graph& graph, const QosProfiles& qos,
                                  const std::map<Role, TrafficRules>& rules,
                                  const PoorPlace& place) {
  std::vector<Finding> findings;
  for (const Node& node : graph) {
    for (const Port& port : node.ports) {
      if (!port.load || port.scope != Scope::link) continue;
      const auto profile = profile_of(port, qos);
      const auto traffic_class = class_above_low(node, port, rules);
      if (!profile || !traffic_class) continue;
      const double bytes_per_s = offered(*port.load, *profile, hosts_beside(graph, node));
      if (bytes_per_s <= place.bytes_per_s) continue;
      findings.push_back(
          {Severity::warning, warning(node, port, *traffic_class, bytes_per_s, place)});
    }
  }
  return findings;
}

}  // namespace tocsin::check
