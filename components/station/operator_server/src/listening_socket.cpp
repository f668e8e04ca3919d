// SPDX-License-Identifier: Apache-2.0
#include "listening_socket.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

namespace tocsin::foxglove {
namespace {

struct Address {
  sockaddr_storage bytes{};
  socklen_t size = 0;
  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes); }
};

std::optional<Address> address_of(const std::string& text, int port) {
  Address address;
  auto* const four = reinterpret_cast<sockaddr_in*>(&address.bytes);
  if (::inet_pton(AF_INET, text.c_str(), &four->sin_addr) == 1) {
    four->sin_family = AF_INET;
    four->sin_port = htons(static_cast<std::uint16_t>(port));
    address.size = sizeof(sockaddr_in);
    return address;
  }
  auto* const six = reinterpret_cast<sockaddr_in6*>(&address.bytes);
  if (::inet_pton(AF_INET6, text.c_str(), &six->sin6_addr) != 1) return std::nullopt;
  six->sin6_family = AF_INET6;
  six->sin6_port = htons(static_cast<std::uint16_t>(port));
  address.size = sizeof(sockaddr_in6);
  return address;
}

/// Nothing for what is no socket of the internet.
std::optional<Address> local_address(int descriptor) {
  Address address;
  address.size = sizeof address.bytes;
  auto* const bytes = reinterpret_cast<sockaddr*>(&address.bytes);
  if (::getsockname(descriptor, bytes, &address.size) != 0) return std::nullopt;
  if (bytes->sa_family != AF_INET && bytes->sa_family != AF_INET6) return std::nullopt;
  return address;
}

int port_of(const Address& address) {
  const auto* const four = reinterpret_cast<const sockaddr_in*>(&address.bytes);
  const auto* const six = reinterpret_cast<const sockaddr_in6*>(&address.bytes);
  return ntohs(address.bytes.ss_family == AF_INET ? four->sin_port : six->sin6_port);
}

/// What a program is started with stays open over exec; what it opens itself does not, here.
bool is_inherited(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFD);
  return flags >= 0 && (flags & FD_CLOEXEC) == 0;
}

bool listens(int descriptor) {
  int listening = 0;
  socklen_t size = sizeof listening;
  return ::getsockopt(descriptor, SOL_SOCKET, SO_ACCEPTCONN, &listening, &size) == 0 &&
         listening != 0;
}

/// A socket that this process was started with and that listens at `wanted`; a copy of it, so that
/// the original stays for a successor in this process.
FileDescriptor inherited_socket(const Address& wanted) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
    const int descriptor = std::atoi(entry.path().filename().c_str());
    const auto address = local_address(descriptor);
    if (!address || !is_inherited(descriptor) || !listens(descriptor) ||
        address->size != wanted.size)
      continue;
    if (std::memcmp(&address->bytes, &wanted.bytes, wanted.size) != 0) continue;
    return FileDescriptor(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
  }
  return FileDescriptor();
}

Listening failed() { return {FileDescriptor(), 0, false, std::system_category().message(errno)}; }

}  // namespace

Listening open_listening_socket(const std::string& text, int port) {
  const auto address = address_of(text, port);
  if (!address) return {FileDescriptor(), 0, false, "'" + text + "' is not an IP address"};
  if (FileDescriptor inherited = inherited_socket(*address); inherited) {
    return {std::move(inherited), port, true};
  }
  FileDescriptor socket(
      ::socket(address->bytes.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int on = 1;  // a restart does not wait for the connections of its predecessor
  if (!socket || ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
      ::bind(socket.get(), address->get(), address->size) != 0 ||
      ::listen(socket.get(), SOMAXCONN) != 0) {
    return failed();
  }
  const auto bound = local_address(socket.get());
  if (!bound) return failed();
  return {std::move(socket), port_of(*bound), false};
}

}  // namespace tocsin::foxglove
