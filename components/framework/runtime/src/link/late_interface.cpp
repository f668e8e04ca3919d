// SPDX-License-Identifier: Apache-2.0
#include "link/late_interface.hpp"

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "foundation/network_interface.hpp"

namespace tocsin {
namespace {

/// Readable whenever an interface or an address changes.
int open_changes() {
  const int socket = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE);
  if (socket < 0) return -1;
  sockaddr_nl own{};
  own.nl_family = AF_NETLINK;
  own.nl_groups = RTMGRP_LINK | RTMGRP_IPV4_IFADDR;
  if (bind(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0) return socket;
  close(socket);
  return -1;
}

/// What the messages say does not matter: all is looked at anew.
void forget_waiting(int socket) {
  std::array<char, 8192> text{};
  while (recv(socket, text.data(), text.size(), 0) > 0) continue;
}

}  // namespace

LateInterface::LateInterface(std::vector<std::string> addresses, std::function<bool()> on_running)
    : addresses_(std::move(addresses)),
      on_running_(std::move(on_running)),
      stop_(eventfd(0, EFD_CLOEXEC)),
      changes_(open_changes()),
      thread_([this] { watch(); }) {
  pthread_setname_np(thread_.native_handle(), "late_interface");
}

LateInterface::~LateInterface() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(stop_, &one, sizeof one);
  thread_.join();
  close(stop_);
  if (changes_ >= 0) close(changes_);
}

bool LateInterface::any_runs(const std::vector<std::string>& addresses) {
  return std::any_of(addresses.begin(), addresses.end(), interface_is_running);
}

void LateInterface::watch() {
  constexpr int longest_ms = 1000;
  std::array<pollfd, 2> polled{{{stop_, POLLIN, 0}, {changes_, POLLIN, 0}}};
  while (!any_runs(addresses_) || !on_running_()) {
    (void)poll(polled.data(), polled.size(), longest_ms);  // skips a negative descriptor
    if (polled[0].revents != 0) return;
    if (changes_ >= 0) forget_waiting(changes_);
  }
}

}  // namespace tocsin
