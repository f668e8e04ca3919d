// SPDX-License-Identifier: Apache-2.0
#include "examine_routers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "foundation/joined.hpp"

namespace tocsin::check {
namespace {

using deployment::Deployment;
using deployment::Host;

std::vector<std::string> routers_of(const Host& host) {
  std::vector<std::string> paths;
  for (const deployment::Container& container : host.containers) {
    for (const deployment::ComponentInstance& one : container.components) {
      if (one.component != "link_router") continue;
      paths.push_back(fmt::format("{}/{}/{}", host.name, container.name, one.name));
    }
  }
  return paths;
}

bool names_as_peer(const Host& host, const Host& other) {
  return std::find(host.peers.begin(), host.peers.end(), other.address) != host.peers.end();
}

/// The first peer of `host` in this file that has a router.
const Host* routed_peer_of(const Host& host, const Deployment& deployment) {
  const auto found =
      std::find_if(deployment.hosts.begin(), deployment.hosts.end(), [&host](const Host& other) {
        return &other != &host && is_routed(other) &&
               (names_as_peer(host, other) || names_as_peer(other, host));
      });
  return found == deployment.hosts.end() ? nullptr : &*found;
}

/// The components of the host that have link topics.
std::vector<std::string> link_users(const Host& host, const Graph& graph) {
  std::vector<std::string> paths;
  for (const Node& node : graph) {
    const bool uses_link = std::any_of(node.ports.begin(), node.ports.end(),
                                       [](const Port& port) { return port.scope == Scope::link; });
    if (uses_link && node.host == host.name) paths.push_back(node.path());
  }
  return paths;
}

/// The first of them, and how many there are beside it.
std::string shortened(const std::vector<std::string>& paths) {
  const std::size_t more = paths.size() - 1;
  return paths.front() + (more > 0 ? fmt::format(" and {} more", more) : "");
}

void examine_host(const Host& host, const Deployment& deployment, const Graph& graph,
                  std::vector<Finding>& findings) {
  const std::vector<std::string> routers = routers_of(host);
  if (routers.size() > 1) {
    findings.push_back({Severity::error,
                        fmt::format("host {}: {} are link_routers; the link has one owner on each "
                                    "host: keep one",
                                    host.name, joined(routers, " and "))});
  }
  if (!routers.empty()) return;
  if (const Host* const peer = routed_peer_of(host, deployment)) {
    findings.push_back(
        {Severity::error,
         fmt::format("host {} has no link_router, its peer {} has {}: they would not hear each "
                     "other; add the component link_router to a container of {}",
                     host.name, peer->name, routers_of(*peer).front(), host.name)});
    return;
  }
  const std::vector<std::string> users = link_users(host, graph);
  if (host.peers.empty() || users.empty()) return;
  findings.push_back(
      {Severity::error,
       fmt::format("host {}: no link_router carries the link topics of {}: they stay on their "
                   "host; add the component link_router to one container of each host",
                   host.name, shortened(users))});
}

}  // namespace

std::vector<Finding> examine_routers(const Deployment& deployment, const Graph& graph) {
  std::vector<Finding> findings;
  for (const Host& host : deployment.hosts) examine_host(host, deployment, graph, findings);
  return findings;
}

}  // namespace tocsin::check
