// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/capability.h>

#include <string>

#include "foundation/file_descriptor.hpp"
#include "foundation/privileges.hpp"

namespace tocsin::cli {

/// What the emulated radio needs of root: to make and enter networks, and its interfaces there.
inline const Capabilities radio_capabilities{CAP_SYS_ADMIN, CAP_NET_ADMIN};

/// Gives this process a mount namespace with a /dev/shm of its own and the right to make network
/// namespaces; without privileges by a new user namespace in which it is root. Call before any
/// thread starts. Throws EnvironmentError when the machine allows neither, or has no TUN.
void enter_private_world();

/// A network namespace without a name: it ends with its last process and descriptor.
class HostNetwork {
 public:
  /// Makes it, with the loopback up and ICMP echo sockets open to all groups.
  /// Throws EnvironmentError.
  HostNetwork();
  /// For setns(2); closed on exec.
  [[nodiscard]] int descriptor() const { return namespace_.get(); }
  /// Whether wlan0 is there, running, and has the IPv4 `address`.
  [[nodiscard]] bool has_link(const std::string& address) const;

 private:
  FileDescriptor namespace_;
  FileDescriptor socket_;  ///< made inside, so that it sees the interfaces there
};

}  // namespace tocsin::cli
