// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "options.hpp"

namespace tocsin::link {

inline constexpr int link_mtu = 1500;

/// A point-to-point interface inside a network namespace whose packets this process carries.
///
/// The interface is persistent: when the process is killed, interface, address and routes stay and
/// only the carrier goes; the next process attaches to it again.
class Tun {
 public:
  /// Enters the namespace, creates or re-attaches the interface, sets address and MTU, brings it
  /// up, and returns to the namespace of the caller. Throws EnvironmentError when the machine or
  /// the privilege does not allow it, and ConfigError when the namespace does not exist.
  Tun(const End& end, const std::string& interface);

  [[nodiscard]] int fd() const { return fd_.get(); }
  /// The next packet; empty when none waits. Does not block.
  [[nodiscard]] std::vector<std::uint8_t> read();
  /// Whether `read` has found that somebody deleted the interface. Nothing passes from then on.
  [[nodiscard]] bool gone() const { return gone_; }
  /// False when the kernel refuses the packet. Does not block.
  [[nodiscard]] bool write(const std::vector<std::uint8_t>& packet);
  /// The interface disappears when this object does.
  void remove_at_end();

 private:
  FileDescriptor fd_;
  bool gone_ = false;
};

/// Whether an IP packet goes to a group: multicast, or the broadcast address 255.255.255.255 or
/// that of a network with this `prefix`. False for what is not IP.
[[nodiscard]] bool is_group_addressed(const std::vector<std::uint8_t>& packet, int prefix);

/// The destination of an IPv4 packet, in network byte order; 0 for another one.
[[nodiscard]] std::uint32_t destination_of(const std::vector<std::uint8_t>& packet);

/// The DSCP of an IP packet, 0 to 63: the upper six bits of IPv4's TOS byte or IPv6's traffic
/// class. 0 for what is not IP.
[[nodiscard]] std::uint8_t dscp_of(const std::vector<std::uint8_t>& packet);

}  // namespace tocsin::link
