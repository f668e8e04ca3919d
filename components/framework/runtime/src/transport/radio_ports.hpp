// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "foundation/time.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Where the paths of a router go; one or two.
struct RadioPlace {
  std::string first_address;                   ///< IPv4 of its interface, which may come later
  std::string second_address = {};             ///< the same; empty: there is one path
  std::vector<std::string> first_peers = {};   ///< IPv4 of the peers by the first path
  std::vector<std::string> second_peers = {};  ///< the same by the second, in the same order
};

/// A packet as it came to a port.
struct RadioPacket {
  const std::uint8_t* bytes;
  std::size_t size;
  sockaddr_in from;
  Duration waited;  ///< in the socket, see SocketWait
};

/// Receives what the peers send, on sockets of its own, which need no interface yet: Fast DDS 3
/// asks once which interfaces there are, and a radio comes and goes. Of two paths Fast DDS knows
/// the first alone: a peer is where its first address is, and its ports are the same on both.
class RadioPorts {
 public:
  using Locator = eprosima::fastdds::rtps::Locator_t;
  /// Called by a thread of the port and path.
  using OnPacket = std::function<void(const RadioPacket&)>;

  explicit RadioPorts(const RadioPlace& place);
  ~RadioPorts();
  RadioPorts(const RadioPorts&) = delete;
  RadioPorts& operator=(const RadioPorts&) = delete;

  /// Keeps a port of the first path for `start`; false: somebody else has it. It is the
  /// participant's for discovery, and the next one is its other.
  [[nodiscard]] bool claim(std::uint16_t port);
  /// Whether that is where this participant receives.
  [[nodiscard]] bool is_own(const Locator& place) const;
  /// Of the second path, packets of peers only. Throws EnvironmentError when the port is taken.
  void start(std::uint16_t port, const OnPacket& on_packet);
  /// Returns when the port's threads have ended.
  void stop(std::uint16_t port);
  [[nodiscard]] bool is_open(std::uint16_t port) const { return ports_.count(port) != 0; }

  /// A peer's place by the other path; nothing when it is no peer's on that one.
  [[nodiscard]] std::optional<Locator> second_of(const Locator& first) const;
  [[nodiscard]] std::optional<Locator> first_of(const Locator& second) const;
  [[nodiscard]] bool is_second(std::uint32_t address) const { return firsts_.count(address) != 0; }
  [[nodiscard]] const std::string& second_address() const { return second_address_; }

 private:
  class Port;
  const std::string first_address_;
  const std::string second_address_;
  std::map<std::uint32_t, std::uint32_t> seconds_;  ///< addresses, host order, by the first ones
  std::map<std::uint32_t, std::uint32_t> firsts_;
  std::map<std::uint16_t, FileDescriptor> claimed_;
  std::uint32_t own_address_ = 0;  ///< host order, of the first path
  std::uint16_t own_port_ = 0;
  std::map<std::uint16_t, std::vector<std::unique_ptr<Port>>> ports_;
};

}  // namespace tocsin
