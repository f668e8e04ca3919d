// SPDX-License-Identifier: Apache-2.0
#include "control_client.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "foundation/error.hpp"

namespace tocsin::kobuki {
namespace {

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw EnvironmentError(path + ": path too long");
  std::copy(path.begin(), path.end(), std::begin(address.sun_path));
  return address;
}

const sockaddr* generic(const sockaddr_un& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

}  // namespace

ControlClient::ControlClient(std::string path)
    : path_(std::move(path)),
      own_path_("/tmp/tocsin-kobuki-" + std::to_string(::getpid()) + ".sock"),
      socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_un own = address_of(own_path_);
  ::unlink(own_path_.c_str());
  if (socket_ >= 0 && ::bind(socket_, generic(own), sizeof own) == 0) return;
  throw EnvironmentError(own_path_ + ": cannot create the socket");
}

ControlClient::~ControlClient() {
  ::close(socket_);
  ::unlink(own_path_.c_str());
}

std::optional<std::string> ControlClient::ask(const std::string& line) {
  const sockaddr_un to = address_of(path_);
  if (::sendto(socket_, line.data(), line.size(), 0, generic(to), sizeof to) < 0) {
    return std::nullopt;
  }
  pollfd asked{socket_, POLLIN, 0};
  if (::poll(&asked, 1, 1000) <= 0) return std::nullopt;
  std::array<char, 2048> text{};
  const auto count = ::recv(socket_, text.data(), text.size(), 0);
  if (count < 0) return std::nullopt;
  return std::string(text.data(), static_cast<std::size_t>(count));
}

}  // namespace tocsin::kobuki
