// SPDX-License-Identifier: Apache-2.0
#include "cable_tap.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace tocsin::interop {
namespace {

/// A packet socket, opened by a thread that has gone into the namespace: a socket stays in the
/// namespace that it was made in.
int open_there(pid_t process, const std::string& interface) {
  int descriptor = -1;
  std::thread visitor([&] {
    const int network = open(("/proc/" + std::to_string(process) + "/ns/net").c_str(), O_RDONLY);
    if (network < 0) return;
    const bool inside = setns(network, CLONE_NEWNET) == 0;
    close(network);
    if (!inside) return;
    descriptor = socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_IP));
    sockaddr_ll there{};
    there.sll_family = AF_PACKET;
    there.sll_protocol = htons(ETH_P_IP);
    there.sll_ifindex = static_cast<int>(if_nametoindex(interface.c_str()));
    if (bind(descriptor, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0) return;
    close(descriptor);
    descriptor = -1;
  });
  visitor.join();
  return descriptor;
}

std::string sender_of(const unsigned char* packet, std::size_t size) {
  constexpr std::size_t protocol_at = 9;
  constexpr std::size_t udp_header_bytes = 8;
  constexpr std::size_t vendor_at = 6;  // RTPS 2.2 section 9.4.4
  const std::size_t rtps = (packet[0] & 0x0fU) * 4 + udp_header_bytes;
  if (packet[protocol_at] == IPPROTO_IGMP) return "igmp";
  if (packet[protocol_at] != IPPROTO_UDP || size < rtps + vendor_at + 2 ||
      std::memcmp(packet + rtps, "RTPS", 4) != 0) {
    return "ip " + std::to_string(packet[protocol_at]);
  }
  const unsigned char* const vendor = packet + rtps + vendor_at;
  return std::to_string(vendor[0]) + "." + std::to_string(vendor[1]);
}

}  // namespace

CableTap::CableTap(pid_t process, const std::string& interface)
    : socket_(open_there(process, interface)) {
  if (socket_ < 0) return;
  const timeval timeout{0, 20'000};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
  thread_ = std::thread([this] { run(); });
}

CableTap::~CableTap() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
  if (socket_ >= 0) close(socket_);
}

std::vector<std::string> CableTap::senders() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return senders_;
}

void CableTap::run() {
  std::array<unsigned char, 2048> packet{};
  while (!stopping_) {
    sockaddr_ll from{};
    socklen_t from_size = sizeof from;
    const ssize_t size = recvfrom(socket_, packet.data(), packet.size(), 0,
                                  reinterpret_cast<sockaddr*>(&from), &from_size);
    if (size < 20 || from.sll_pkttype == PACKET_OUTGOING) continue;
    const std::string sender = sender_of(packet.data(), static_cast<std::size_t>(size));
    const std::lock_guard<std::mutex> lock(mutex_);
    senders_.push_back(sender);
  }
}

}  // namespace tocsin::interop
