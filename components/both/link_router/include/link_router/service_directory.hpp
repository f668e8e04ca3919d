// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "foundation/time.hpp"

namespace tocsin::router {

/// A service by its names of ROS 2.
struct ServiceName {
  std::string name;
  std::string type;
};
[[nodiscard]] inline bool operator<(const ServiceName& one, const ServiceName& other) {
  return std::tie(one.name, one.type) < std::tie(other.name, other.type);
}
[[nodiscard]] inline bool operator==(const ServiceName& one, const ServiceName& other) {
  return one.name == other.name && one.type == other.type;
}

/// What a router announces to its peers of services.
struct ServiceLists {
  std::set<ServiceName> offered;  ///< by servers of its host
  std::set<ServiceName> wanted;   ///< by clients of its host
};
[[nodiscard]] inline bool operator==(const ServiceLists& one, const ServiceLists& other) {
  return one.offered == other.offered && one.wanted == other.wanted;
}

/// Whether calls of a service cross the link.
enum class Crossing : std::uint8_t {
  no,
  on_demand,  ///< it is shown to the far host while somebody there calls it
  always,     ///< it is shown there as long as it is served
};

/// Which services a router offers to its peers, wants of them, shows on its host in their place,
/// and asks on its host in their place.
///
/// A server on the same host goes first: what is served there is neither wanted nor shown. A client
/// waits 0.5 s for one to be made, since servers of nodes are made for who calls them. Of a peer it
/// takes no more than `most_services` names of each list, and those of the rules only. Pure; `now`
/// never decreases.
class ServiceDirectory {
 public:
  using PeerInstance = std::uint64_t;
  static constexpr std::size_t most_services = 256;
  /// By the service's name.
  struct Rules {
    std::function<Crossing(const std::string&)> served;  ///< by this host for the peers
    std::function<Crossing(const std::string&)> called;  ///< by this host at the peers
  };
  explicit ServiceDirectory(Rules rules) : rules_(std::move(rules)) {}

  void on_server(const ServiceName& service, bool there);
  void on_client(const ServiceName& service, bool there, Time now);
  /// Returns what it does not take.
  std::set<std::string> on_peer(PeerInstance peer, const ServiceLists& lists);
  void forget_peer(PeerInstance peer);

  [[nodiscard]] ServiceLists announced(Time now) const;
  /// To serve on this host; at most one of each name.
  [[nodiscard]] std::set<ServiceName> shown(Time now) const;
  /// Names of what peers offer and nobody serves on this host, shown here or not.
  [[nodiscard]] std::set<std::string> offered_there() const;
  /// To be a client of on this host; at most one of each name.
  [[nodiscard]] std::set<ServiceName> asked() const;
  /// Whether one of these may be another than at the last call of this; true at first.
  [[nodiscard]] bool has_changed(Time now);
  /// When one of these changes though nothing happens; `never` when none does.
  [[nodiscard]] Time deadline(Time now) const;

 private:
  [[nodiscard]] bool is_served_here(const std::string& name) const;
  [[nodiscard]] bool is_wanted_there(const std::string& name) const;
  [[nodiscard]] bool is_wanted_here(const std::string& name, Time now) const;

  Rules rules_;
  std::set<ServiceName> servers_;
  std::map<ServiceName, Time> clients_;  ///< since when
  std::map<PeerInstance, ServiceLists> peers_;
  bool changed_ = true;
  Time changes_at_ = never;
};

}  // namespace tocsin::router
