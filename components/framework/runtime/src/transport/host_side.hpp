// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "transport/guarded_transport.hpp"

namespace tocsin {

/// UDP of a host's own domain: ordinary participants of this host with their default settings find
/// us and we them, and no datagram comes from another machine or goes to one.
///
/// Samples and unicast discovery use loopback, which every peer of this host reaches. Participants
/// announce themselves to the discovery group, on loopback and wherever another program of this
/// host listens to it, and hear it there. Throws EnvironmentError, see HostMulticastReceiver.
///
/// `socket_bytes`: size of the buffer of its sending socket.
[[nodiscard]] std::shared_ptr<TransportSide> host_side(int domain, std::uint32_t socket_bytes);

}  // namespace tocsin
