// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>
#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "foundation/time.hpp"

namespace tocsin {

/// A UDP socket of this computer, as the kernel tells of it.
struct UdpSocket {
  uid_t user = 0;
  /// Made by sole_udp_socket: no other socket can have its port, at whatever address.
  bool is_sole = false;
};

/// The kernel's table of UDP sockets of this network (sock_diag(7)). One thread at a time.
class UdpSockets {
 public:
  UdpSockets();
  /// Whether the kernel answers at all: it may have been built without (INET_UDP_DIAG), or a
  /// sandbox may keep AF_NETLINK from us.
  [[nodiscard]] bool answers() { return at(sockaddr_in{}).has_value(); }

  /// Some or none.
  using Found = std::vector<UdpSocket>;
  /// The socket that gets what a stranger sends to `place`; empty when none does. Nothing when the
  /// kernel does not answer. 0.8 us.
  [[nodiscard]] std::optional<Found> at(const sockaddr_in& place);
  /// Every socket with that port, at whatever address. Nothing when the kernel does not answer.
  /// 22 us: the kernel walks through its whole table.
  [[nodiscard]] std::optional<Found> with_port(std::uint16_t port);

 private:
  [[nodiscard]] bool add_with_port(std::uint8_t family, std::uint16_t port, Found& found);
  FileDescriptor netlink_;
};

/// A socket for sending whose datagrams nobody else can pass for his own.
///
/// On Linux who has a port at one address of a computer may send as if he had it at another
/// (IP_PKTINFO). So this one is bound to all addresses, which leaves its port to nobody else, and
/// bears options that, together, no other program has, by which UdpSockets tells it. It hears
/// nothing. Throws EnvironmentError.
[[nodiscard]] FileDescriptor sole_udp_socket();

/// [byte] Room for any datagram.
inline constexpr std::size_t datagram_room = 65'536;
using OnDatagram = std::function<void(const std::uint8_t*, std::size_t, const sockaddr_in& from)>;
/// Hands on what comes until `stopping`; who sets it wakes the thread by a shutdown of the socket.
void receive_datagrams(const FileDescriptor& socket, const std::atomic<bool>& stopping,
                       const OnDatagram& on_datagram);
/// The same; when it has handed on all, it lets more come for as long as `pause` said after the
/// last one.
void receive_datagrams(const FileDescriptor& socket, const std::atomic<bool>& stopping,
                       const OnDatagram& on_datagram, const std::function<Duration()>& pause);

}  // namespace tocsin
