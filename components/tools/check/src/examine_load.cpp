// SPDX-License-Identifier: Apache-2.0
#include "examine_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "foundation/error.hpp"
#include "rtps_model/message.hpp"

namespace tocsin::check {
namespace {

/// Processes on other hosts that read the topic: each gets a copy.
std::size_t readers_of(const Graph& graph, const Node& writer, const std::string& topic) {
  std::set<std::string> processes;
  for (const Node& node : graph) {
    const bool reads = std::any_of(node.ports.begin(), node.ports.end(), [&](const Port& port) {
      return !port.writes && port.topic == topic;
    });
    if (reads && node.host != writer.host) processes.insert(node.host + "/" + node.container);
  }
  return processes.size();
}

/// [byte/s] in IP packets to all readers.
double offered(const ExpectedLoad& load, const QosProfile& qos, const QosProfiles& all,
               std::size_t readers) {
  const auto packets =
      rtps::packets_of(static_cast<std::size_t>(load.bytes), readers, rtps::wire::largest_payload);
  const auto bytes = std::accumulate(packets.begin(), packets.end(), std::size_t{0});
  double rate = std::min(load.rate_hz, qos.max_rate_hz) * static_cast<double>(bytes);
  if (!qos.flow_controller.empty()) {
    const FlowController& bound = all.flow_controllers().at(qos.flow_controller);
    if (bound.max_bytes_per_period > 0) {
      rate = std::min(rate, bound.max_bytes_per_period / bound.period_s);
    }
  }
  return rate * static_cast<double>(readers);
}

/// Empty when the profile is missing, which is told elsewhere.
std::optional<QosProfile> profile_of(const Port& port, const QosProfiles& qos) {
  try {
    return qos.of(port.qos, port.topic);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

std::string warning(const Node& node, const Port& port, std::size_t readers, double bytes_per_s,
                    const PoorPlace& place) {
  return fmt::format(
      "topic {}: {} writes it reliably (QoS profile {}), {:.0f} kB/s on the radio to {} "
      "process{}; in its poor places ({:.0f} dB) {} carries {:.0f} kB/s, and what is repaired "
      "there "
      "takes the place of all other topics: use reliability: best_effort or a flow_controller",
      port.topic, node.path(), port.qos, bytes_per_s / 1000, readers, readers == 1 ? "" : "es",
      place.mean_snr_db, place.channel, place.bytes_per_s / 1000);
}

}  // namespace

std::vector<Finding> examine_load(const Graph& graph, const QosProfiles& qos,
                                  const PoorPlace& place) {
  std::vector<Finding> findings;
  for (const Node& node : graph) {
    for (const Port& port : node.ports) {
      if (!port.load || port.scope != Scope::link) continue;
      const auto profile = profile_of(port, qos);
      const std::size_t readers = readers_of(graph, node, port.topic);
      if (!profile || !profile->reliable() || readers == 0) continue;
      const double bytes_per_s = offered(*port.load, *profile, qos, readers);
      if (bytes_per_s <= place.bytes_per_s) continue;
      findings.push_back({Severity::warning, warning(node, port, readers, bytes_per_s, place)});
    }
  }
  return findings;
}

}  // namespace tocsin::check
