// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

#include "rtps_filter/source.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {

/// Whether the sockets that may have sent a datagram are all of users who may speak: `own`, and
/// root, who may do anything here anyway.
[[nodiscard]] rtps_filter::Sender sender_among(const UdpSockets::Found& sockets, uid_t own);

/// Tells whose datagrams are that were sent on this computer, so that other users neither load
/// components, nor stop or drive anything, by speaking on its loopback. Any thread.
///
/// The kernel is asked of each datagram: whatever is remembered of a socket another user can take
/// over. What our processes send comes from sockets that have their port alone (sole_udp_socket),
/// and costs one question. With those of other DDS implementations it takes a look at all sockets
/// of the port.
class SenderUsers {
 public:
  SenderUsers();
  /// False where the kernel does not tell: everybody on this computer is trusted then.
  [[nodiscard]] bool can_tell() const { return can_tell_; }
  /// `from`: an address of this computer.
  [[nodiscard]] rtps_filter::Sender sender(const rtps_filter::Source& from);

 private:
  std::mutex mutex_;
  UdpSockets sockets_;
  const uid_t own_;
  const bool can_tell_;
};

}  // namespace tocsin
