// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/fast_dds_transport.hpp"

#include <filesystem>

#include "fast_dds/remote_ends.hpp"
#include "keystore/enclave.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/fast_dds/transport.hpp"
#include "runtime/middleware/fast_dds_qos.hpp"
#include "runtime/middleware/link_limits.hpp"
#include "transport/host_multicast.hpp"
#include "transport/host_side.hpp"
#include "transport/packet_filter.hpp"
#include "transport/radio_side.hpp"
#include "transport/radio_socket.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;

/// A picture of a few MB in one burst must fit; the kernel caps it at net.core.rmem_max.
constexpr std::uint32_t host_socket_bytes = 4U << 20U;

bool is_on_link(const ParticipantOptions& options) {
  return options.marks != nullptr || !options.peers.empty();
}

rtps::Locator_t udp_locator(const std::string& address, int port) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(locator, address);
  locator.port = static_cast<std::uint32_t>(port);
  return locator;
}

/// The well-known port for discovery of a domain's participant, RTPS 2.2 section 9.6.1.1; the one
/// for data follows it.
int discovery_port(int domain, int participant) { return 7410 + 250 * domain + 2 * participant; }

/// Routers that may share one address; more than one only where a test needs no second interface.
constexpr int most_at_one_address = 3;

/// Where routers receive discovery that are at one of these.
std::vector<rtps::Locator_t> router_ports(const ParticipantOptions& options,
                                          const std::vector<std::string>& peers) {
  std::vector<rtps::Locator_t> all;
  for (const std::string& peer : peers) {
    for (int i = 0; i < (peer == options.address ? most_at_one_address : 1); ++i) {
      all.push_back(udp_locator(peer, discovery_port(options.domain, i)));
    }
  }
  return all;
}

/// Of each path.
std::vector<rtps::Locator_t> stop_ports(const ParticipantOptions& options) {
  auto all = router_ports(options, options.peers);
  for (const rtps::Locator_t& one : router_ports(options, options.second_peers)) {
    all.push_back(one);
  }
  return all;
}

std::shared_ptr<RadioPorts> ports_of(const ParticipantOptions& options) {
  if (!options.second_address.empty()) options.marks->add_path();
  return std::make_shared<RadioPorts>(
      RadioPlace{options.address, options.second_address, options.peers, options.second_peers});
}

std::shared_ptr<UDPv4TransportDescriptor> udp_of(const ParticipantOptions& options) {
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  // A router's opens nothing: RadioPorts does, whether or not an interface is there yet.
  if (!options.marks) udp->interfaceWhiteList = {options.address};
  if (!is_on_link(options)) udp->sendBufferSize = udp->receiveBufferSize = host_socket_bytes;
  return udp;
}

/// Null on a link without marks.
std::shared_ptr<TransportSide> side_of(const ParticipantOptions& options,
                                       const std::shared_ptr<OtherVendors>& others) {
  if (!is_on_link(options)) return host_side(options.domain, host_socket_bytes);
  if (!options.marks) return nullptr;
  auto repeats = others ? std::make_shared<AuthenticationRepeats>() : nullptr;
  return radio_side(options.address, {options.marks, others, std::move(repeats), options.stop,
                                      stop_ports(options), ports_of(options)});
}

/// Whether nobody else has it, nor gets it from now on if `side` receives by ports of its own.
bool take(const ParticipantOptions& options, TransportSide* side, int port) {
  const auto number = static_cast<std::uint16_t>(port);
  if (side != nullptr && side->ports() != nullptr) return side->ports()->claim(number);
  return static_cast<bool>(radio_socket(options.address, number));
}

/// A router's ports are known, so that one announcement finds it.
void locate_on_link(const ParticipantOptions& options, TransportSide* side,
                    dds::DomainParticipantQos& qos) {
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  int own = 0;
  while (own + 1 < most_at_one_address &&
         !take(options, side, discovery_port(options.domain, own))) {
    ++own;
  }
  const int port = discovery_port(options.domain, own);
  builtin.metatrafficUnicastLocatorList.push_back(udp_locator(options.address, port));
  qos.wire_protocol().default_unicast_locator_list.push_back(
      udp_locator(options.address, port + 1));
  for (const rtps::Locator_t& peer : router_ports(options, options.peers)) {
    builtin.initialPeersList.push_back(peer);
  }
  builtin.discovery_config.leaseDuration = dds_duration(link_lease_s);
  // Two packets each time: Fast DDS announces to the peer's address and to the peer it has found.
  builtin.discovery_config.leaseDuration_announcementperiod = dds_duration(2);
}

/// Numbers of participants that peers without multicast have, and look for: Cyclone DDS gives
/// itself the first free one of ten where its interface cannot multicast, such as loopback.
constexpr int numbers_of_others = 10;

/// Everybody on the host is found by the discovery group, however many they are; we leave the low
/// numbers to those who are found by them alone.
void locate_on_host(const ParticipantOptions& options, dds::DomainParticipantQos& qos) {
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  const rtps::Locator_t group = udp_locator(discovery_group, discovery_group_port(options.domain));
  const int port = discovery_port(options.domain, numbers_of_others);
  builtin.metatrafficMulticastLocatorList.push_back(group);
  builtin.metatrafficUnicastLocatorList.push_back(udp_locator(options.address, port));
  qos.wire_protocol().default_unicast_locator_list.push_back(
      udp_locator(options.address, port + 1));
  builtin.initialPeersList.push_back(group);
  for (int i = 0; i < numbers_of_others; ++i) {
    builtin.initialPeersList.push_back(
        udp_locator(options.address, discovery_port(options.domain, i)));
  }
  builtin.discovery_config.leaseDuration = dds_duration(5);
  // A peer that was stopped for longer than the lease has forgotten us, and waits for this.
  builtin.discovery_config.leaseDuration_announcementperiod = dds_duration(0.5);
}

/// DDS Security 1.1 with the plug-ins of its clause 9, with the files of a SROS2 enclave.
void secure(const std::string& enclave, dds::DomainParticipantQos& qos) {
  auto& properties = qos.properties().properties();
  const auto add = [&](const char* name, const std::string& value) {
    properties.emplace_back(name, value);
  };
  const auto add_file = [&](const char* name, const char* file) {
    add(name, "file://" + enclave + "/" + file);
  };
  add("dds.sec.auth.plugin", "builtin.PKI-DH");
  add_file("dds.sec.auth.builtin.PKI-DH.identity_ca", keystore::enclave_file::identity_ca);
  add_file("dds.sec.auth.builtin.PKI-DH.identity_certificate", keystore::enclave_file::certificate);
  add_file("dds.sec.auth.builtin.PKI-DH.private_key", keystore::enclave_file::key);
  if (std::filesystem::exists(enclave + "/" + keystore::enclave_file::revocations)) {
    add_file("dds.sec.auth.builtin.PKI-DH.identity_crl", keystore::enclave_file::revocations);
  }
  add("dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC");
  add("dds.sec.access.plugin", "builtin.Access-Permissions");
  add_file("dds.sec.access.builtin.Access-Permissions.permissions_ca",
           keystore::enclave_file::permissions_ca);
  add_file("dds.sec.access.builtin.Access-Permissions.governance",
           keystore::enclave_file::governance);
  add_file("dds.sec.access.builtin.Access-Permissions.permissions",
           keystore::enclave_file::permissions);
}

}  // namespace

std::shared_ptr<PacketFilter> packet_filter(const ParticipantOptions& options) {
  const Surroundings surroundings{options.address, options.peers, is_on_link(options)};
  rtps_filter::Limits limits = limits_in(surroundings);
  limits.secured = !options.enclave.empty();
  if (!surroundings.radio) {
    limits.finds = [own = options.user_data](std::string_view other) {
      return find_each_other(own, std::string(other));
    };
  }
  auto others = limits.secured ? std::make_shared<OtherVendors>() : nullptr;
  return std::make_shared<PacketFilter>(std::move(limits), local_in(surroundings),
                                        std::move(others), options.numbers);
}

dds::DomainParticipantQos participant_qos(const ParticipantOptions& options) {
  dds::DomainParticipantQos qos;
  qos.name(options.name);
  qos.user_data().data_vec({options.user_data.begin(), options.user_data.end()});
  qos.transport().use_builtin_transports = false;
  // Others match by the name of a type: Fast DDS 3 would announce all of it.
  qos.properties().properties().emplace_back("fastdds.type_propagation", "disabled");
  auto filter = options.filter ? options.filter : packet_filter(options);
  if (!options.enclave.empty()) secure(options.enclave, qos);
  const auto side = side_of(options, filter->others());
  qos.transport().user_transports = {
      guarded_transport({udp_of(options), side, options.reception, filter})};
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  builtin.avoid_builtin_multicast = true;
  is_on_link(options) ? locate_on_link(options, side.get(), qos) : locate_on_host(options, qos);
  builtin.discovery_config.initial_announcements.count = 10;
  builtin.discovery_config.initial_announcements.period = dds_duration(0.1);
  return qos;
}

}  // namespace tocsin
