// SPDX-License-Identifier: Apache-2.0
#include "foundation/datagram_socket.hpp"

#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

FileDescriptor open_socket() {
  FileDescriptor fd(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!fd) throw EnvironmentError(std::string("cannot open a socket: ") + std::strerror(errno));
  return fd;
}

/// Empty when the path is too long.
std::optional<sockaddr_un> address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return std::nullopt;
  std::copy(path.begin(), path.end(), std::begin(address.sun_path));
  return address;
}

const sockaddr* generic(const sockaddr_un& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

void remove_stale(const std::string& path, const sockaddr_un& address) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0) return;
  if (!S_ISSOCK(found.st_mode)) throw ConfigError(path + ": exists and is not a socket");
  const FileDescriptor probe = open_socket();
  if (::connect(probe.get(), generic(address), sizeof address) == 0) {
    throw ConfigError(path + ": another process listens there");
  }
  ::unlink(path.c_str());
}

}  // namespace

DatagramSocket::DatagramSocket() : socket_(open_socket()) {}

DatagramSocket::DatagramSocket(const std::string& path) : socket_(open_socket()) {
  const auto address = address_of(path);
  if (!address) throw ConfigError(path + ": is longer than 107 characters");
  remove_stale(path, *address);
  if (::bind(socket_.get(), generic(*address), sizeof *address) != 0) {
    throw ConfigError(path + ": cannot create the socket: " + std::strerror(errno));
  }
  path_ = path;
}

DatagramSocket::~DatagramSocket() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

std::optional<DatagramSocket::Message> DatagramSocket::receive() {
  std::array<char, 2048> text{};
  sockaddr_un from{};
  socklen_t from_size = sizeof from;
  const auto count = ::recvfrom(socket_.get(), text.data(), text.size(), 0,
                                reinterpret_cast<sockaddr*>(&from), &from_size);
  if (count < 0) return std::nullopt;
  Message message{{text.data(), static_cast<std::size_t>(count)}, {}};
  if (from_size > offsetof(sockaddr_un, sun_path)) message.sender = from.sun_path;
  return message;
}

std::error_code DatagramSocket::send(const std::string& path, const std::string& text) {
  auto address = address_of(path);
  if (!address) return std::make_error_code(std::errc::filename_too_long);
  socklen_t size = sizeof *address;
  if (path.rfind('@', 0) == 0) {  // the name is as long as it is, without a 0 at its end
    address->sun_path[0] = '\0';
    size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  }
  const auto sent =
      ::sendto(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL, generic(*address), size);
  return sent < 0 ? std::error_code(errno, std::system_category()) : std::error_code();
}

}  // namespace tocsin
