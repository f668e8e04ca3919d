// SPDX-License-Identifier: Apache-2.0
#include "parts.hpp"

#include <algorithm>

namespace tocsin::deployment {
namespace {

/// Leaves of the station what serves this vehicle, or all.
void keep_for(const std::string& vehicle, Host& station) {
  auto& containers = station.containers;
  const auto of_another = [&](const Container& one) {
    return !one.vehicle.empty() && one.vehicle != vehicle;
  };
  containers.erase(std::remove_if(containers.begin(), containers.end(), of_another),
                   containers.end());
}

}  // namespace

void keep_own_ends(Deployment& part) {
  const auto names = process_names(part);
  const auto of_another = [&](const std::string& one) {
    return std::find(names.begin(), names.end(), one) == names.end();
  };
  auto& last = part.stop_when_exits;
  last.erase(std::remove_if(last.begin(), last.end(), of_another), last.end());
}

/// "host/process" of every process, in starting order.
std::vector<std::string> process_names(const Deployment& deployment) {
  std::vector<std::string> names;
  for (const Host& host : deployment.hosts) {
    for (const Program& program : host.programs) names.push_back(host.name + "/" + program.name);
    for (const Container& container : host.containers) {
      names.push_back(host.name + "/" + container.name);
    }
  }
  return names;
}

bool is_vehicle(const Deployment& deployment, const std::string& name) {
  const auto& all = deployment.vehicles;
  return std::find(all.begin(), all.end(), name) != all.end();
}

Deployment part_of(const Deployment& deployment, const std::string& vehicle) {
  const auto& all = deployment.vehicles;
  const auto found = std::find(all.begin(), all.end(), vehicle);
  if (found == all.end()) return deployment;
  Deployment part = deployment;
  const auto index = static_cast<std::size_t>(found - all.begin());
  part.link_domain += static_cast<int>(index);
  part.run_dir += "/" + vehicle;
  part.vehicles.clear();
  part.hosts.clear();
  for (Host host : deployment.hosts) {
    if (host.name != vehicle && is_vehicle(deployment, host.name)) continue;
    if (host.name != vehicle && !deployment.relay) host.peers = {host.peers.at(index)};
    keep_for(vehicle, host);
    part.hosts.push_back(std::move(host));
  }
  keep_own_ends(part);
  return part;
}

std::vector<Deployment> parts_of(const Deployment& deployment) {
  if (deployment.vehicles.empty()) return {deployment};
  std::vector<Deployment> parts;
  for (const std::string& vehicle : deployment.vehicles) {
    parts.push_back(part_of(deployment, vehicle));
  }
  return parts;
}

std::string vehicle_of(const Deployment& deployment, const Host& host, const Container& container) {
  return is_vehicle(deployment, host.name) ? host.name : container.vehicle;
}

std::string namespace_of(const Deployment& deployment, const Host& host,
                         const Container& container) {
  const std::string inner = routed_namespace_of(deployment, container);
  const bool relays = deployment.relay && deployment.relay->site == host.name;
  return relays && !container.vehicle.empty() ? deployment.relay->station + "/" + inner : inner;
}

std::string routed_namespace_of(const Deployment& deployment, const Container& container) {
  const std::string& outer = deployment.ros_namespace;
  return outer + (outer.empty() || container.vehicle.empty() ? "" : "/") + container.vehicle;
}

std::vector<std::string> peer_names_of(const Deployment& deployment, const Host& host,
                                       const Container& container) {
  if (container.vehicle.empty()) return host.sites;
  if (!deployment.relay) return {container.vehicle};
  const Relay& relay = *deployment.relay;
  return {relay.site == host.name ? relay.station : relay.site};
}

std::string folder_of(const Deployment& deployment, const Host& host) {
  const auto first = std::find_if(deployment.hosts.begin(), deployment.hosts.end(),
                                  [](const Host& one) { return one.role == Role::gcs; });
  const bool is_further = host.role == Role::gcs && first != deployment.hosts.end() &&
                          first->name != host.name && !deployment.relay;
  return deployment.run_dir + (is_further ? "/" + host.name : "");
}

std::string run_dir_of(const Deployment& deployment, const Host& host, const Container& container) {
  return folder_of(part_of(deployment, vehicle_of(deployment, host, container)), host);
}

}  // namespace tocsin::deployment
