// SPDX-License-Identifier: Apache-2.0
#include "radio_tap.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace tocsin {
namespace {

/// A packet socket on wlan0, opened by a thread that has gone into the namespace: a socket stays
/// in the namespace that it was made in.
int open_there(pid_t process) {
  int socket_fd = -1;
  std::thread visitor([&] {
    const int ns = open(("/proc/" + std::to_string(process) + "/ns/net").c_str(), O_RDONLY);
    if (ns < 0) return;
    const bool inside = setns(ns, CLONE_NEWNET) == 0;
    close(ns);
    if (!inside) return;
    socket_fd = socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_IP));
    sockaddr_ll radio{};
    radio.sll_family = AF_PACKET;
    radio.sll_protocol = htons(ETH_P_IP);
    radio.sll_ifindex = static_cast<int>(if_nametoindex("wlan0"));
    const auto* address = reinterpret_cast<const sockaddr*>(&radio);
    if (bind(socket_fd, address, sizeof radio) == 0) return;
    close(socket_fd);
    socket_fd = -1;
  });
  visitor.join();
  return socket_fd;
}

}  // namespace

RadioTap::RadioTap(pid_t process) : socket_(open_there(process)) {
  if (socket_ < 0) return;
  const timeval timeout{0, 20'000};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
  thread_ = std::thread([this] { run(); });
}

RadioTap::~RadioTap() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
  if (socket_ >= 0) close(socket_);
}

bool RadioTap::saw(const std::string& bytes) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return bytes_.find(bytes) != std::string::npos;
}

void RadioTap::run() {
  std::array<char, 2048> packet{};
  while (!stopping_) {
    const ssize_t size = recv(socket_, packet.data(), packet.size(), 0);
    if (size < 20) continue;
    ++packets_;
    if ((static_cast<unsigned char>(packet[16]) & 0xF0U) == 0xE0U) ++multicasts_;
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes_.append(packet.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace tocsin
