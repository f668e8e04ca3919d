// SPDX-License-Identifier: Apache-2.0
// How the participants of routers are called. Pure.
#pragma once

#include <string>

namespace tocsin {

/// The link's participant of a host has the host's name and this.
inline const std::string router_suffix = "_link_router";
/// The router's node in the graph of ROS 2 has the ends that it has on its host.
inline constexpr const char* router_node = "_link_router_host";

/// The host whose router a participant is; its own name when it is none.
[[nodiscard]] inline std::string host_in(const std::string& participant) {
  const std::size_t end = participant.rfind(router_suffix);
  const bool router = end != std::string::npos && end + router_suffix.size() == participant.size();
  return router ? participant.substr(0, end) : participant;
}

}  // namespace tocsin
