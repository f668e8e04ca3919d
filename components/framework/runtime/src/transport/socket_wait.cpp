// SPDX-License-Identifier: Apache-2.0
#include "transport/socket_wait.hpp"

#include <linux/sockios.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "watch/own_sockets.hpp"

namespace tocsin {
namespace {

thread_local Duration handed_on_waited{0};

/// -1: none.
int own_socket_at(std::uint16_t port) {
  for (const OwnSocket& one : own_udp_sockets()) {
    if (one.port == port) return one.descriptor;
  }
  return -1;
}

Duration wall_now() {
  return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch());
}

}  // namespace

SocketWait::SocketWait(std::uint16_t port) : socket_(own_socket_at(port)) {
  (void)of_last();  // from the first question on the kernel notes it
}

SocketWait::SocketWait(const FileDescriptor& socket) : socket_(socket.get()) { (void)of_last(); }

Duration SocketWait::of_last() const {
  timespec came{};
  if (socket_ < 0 || ::ioctl(socket_, SIOCGSTAMPNS, &came) != 0) return Duration{0};
  const Duration at = std::chrono::seconds(came.tv_sec) + std::chrono::nanoseconds(came.tv_nsec);
  return std::max(wall_now() - at, Duration{0});
}

Duration waited_in_socket() { return handed_on_waited; }

HandingOn::HandingOn(Duration waited) { handed_on_waited = waited; }
HandingOn::~HandingOn() { handed_on_waited = Duration{0}; }

}  // namespace tocsin
