// SPDX-License-Identifier: Apache-2.0
#include "watch/own_sockets.hpp"

#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

namespace tocsin {
namespace {

std::optional<std::uint16_t> udp_port_of(int descriptor) {
  int type = 0;
  socklen_t type_size = sizeof type;
  sockaddr_in own{};
  socklen_t own_size = sizeof own;
  const bool is_udp =
      ::getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &type_size) == 0 && type == SOCK_DGRAM &&
      ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&own), &own_size) == 0 &&
      own.sin_family == AF_INET;
  return is_udp ? std::optional(ntohs(own.sin_port)) : std::nullopt;
}

}  // namespace

std::vector<OwnSocket> own_udp_sockets() {
  std::vector<OwnSocket> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const int descriptor = std::atoi(entry.path().filename().c_str());
    if (const auto port = udp_port_of(descriptor)) found.push_back({descriptor, *port});
  }
  return found;
}

std::set<std::uint16_t> unread_ports() {
  std::set<std::uint16_t> ports;
  for (const OwnSocket& one : own_udp_sockets()) {
    int bytes = 0;
    if (::ioctl(one.descriptor, FIONREAD, &bytes) == 0 && bytes > 0) ports.insert(one.port);
  }
  return ports;
}

}  // namespace tocsin
