// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/role.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// How many bytes of a gid are sent: 24 in Humble and before, the last 8 zero; 16 since Iron.
enum class GidSize { bytes_16, bytes_24 };

/// What one process needs to join the DDS domain of its host, and a router that of the link.
struct BusOptions {
  std::string name;                      ///< participant name, shown by discovery tools
  Role role = Role::uxv;                 ///< which rules of traffic.yaml hold
  std::string ros_namespace;             ///< of all topics on the host; empty for none
  std::string qos_file;                  ///< empty: the profiles that are built in
  std::string traffic_file;              ///< empty: any link topic may be written
  int host_domain = 0;                   ///< [0, 231] of topics that stay on this host
  int link_domain = 1;                   ///< [0, 231] of topics that cross the radio
  std::string link_address;              ///< of a router: own IPv4 on the link; empty: no link
  std::vector<std::string> link_peers;   ///< of a router: IPv4 of the other sides
  std::string host = "";                 ///< name of this side, as the peers of its router know it
  std::optional<GidSize> gid_size = {};  ///< told to ROS 2; empty: what its peers take
  /// Of a router: folder with its identity for DDS Security, laid out as an enclave of SROS2;
  /// empty: the link is open.
  std::string enclave = "";
  bool plain_names = false;  ///< topics are called on the wire as they are, without ROS's `rt/`
  /// Of a router: whether topics of the chain before the wheels may cross, see TrafficRules.
  VehicleChain chain = VehicleChain::foreign;
  std::string second_address = "";             ///< of a second path over the link; empty: none
  std::vector<std::string> second_peers = {};  ///< IPv4 of the other sides by it, in the same order
  /// Of a router: names of the hosts that its link is to, on a secured link of their identities.
  /// Nothing is taken of others. Empty: whoever comes.
  std::vector<std::string> peer_names = {};
  /// Of a vehicle's router that has several sites: their names, the preferred one first, in the
  /// order of link_peers. It speaks with one at a time.
  std::vector<std::string> sites = {};
  /// Of a router: namespace of the topics that it takes from the host and gives there, where that
  /// is another than that of its own.
  std::optional<std::string> routed_namespace = {};
  /// Whom the process serves at a station of several vehicles: it and those of another vehicle do
  /// not find each other. Empty: all find it.
  std::string vehicle = {};
};

/// The bus on Fast DDS in real time. All topics stay on the host, where any participant with the
/// default settings of its library finds them; what crosses the link does so by the host's router.
/// Advertising a link topic that `traffic_file` does not name throws ConfigError.
///
/// Throws ConfigError for bad files, EnvironmentError when a participant cannot be created.
[[nodiscard]] std::unique_ptr<Bus> make_fast_dds_bus(const BusOptions& options);

/// The way of a host's router over the radio, on two participants of its own. While no interface
/// with `link_address` is up, flows of the link wait. Throws EnvironmentError when a participant
/// cannot be created.
[[nodiscard]] std::unique_ptr<LinkBus> make_fast_dds_link_bus(const BusOptions& options,
                                                              std::function<void()> on_event);

}  // namespace tocsin
