// SPDX-License-Identifier: Apache-2.0
#include "packet_tap.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <utility>

namespace tocsin {
namespace {

/// A packet socket, opened by a thread that has gone into the namespace: a socket stays
/// in the namespace that it was made in.
int open_there(pid_t process, const std::string& interface) {
  int socket_fd = -1;
  std::thread visitor([&] {
    const int ns = open(("/proc/" + std::to_string(process) + "/ns/net").c_str(), O_RDONLY);
    if (ns < 0) return;
    const bool inside = setns(ns, CLONE_NEWNET) == 0;
    close(ns);
    if (!inside) return;
    socket_fd = socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_ALL));
    sockaddr_ll there{};
    there.sll_family = AF_PACKET;
    there.sll_protocol = htons(ETH_P_ALL);  // one for IP alone hears nothing of what leaves
    there.sll_ifindex = static_cast<int>(if_nametoindex(interface.c_str()));
    const auto* address = reinterpret_cast<const sockaddr*>(&there);
    if (bind(socket_fd, address, sizeof there) == 0) return;
    close(socket_fd);
    socket_fd = -1;
  });
  visitor.join();
  return socket_fd;
}

std::int64_t time_in(msghdr& message) {
  for (cmsghdr* one = CMSG_FIRSTHDR(&message); one != nullptr; one = CMSG_NXTHDR(&message, one)) {
    if (one->cmsg_level != SOL_SOCKET || one->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec time{};
    std::memcpy(&time, CMSG_DATA(one), sizeof time);
    return time.tv_sec * 1'000'000'000 + time.tv_nsec;
  }
  return 0;
}

/// Nothing when none came within the socket's timeout.
std::optional<TappedPacket> receive(int socket) {
  constexpr ssize_t ip_header = 20;
  std::array<std::uint8_t, 65536> bytes{};
  alignas(cmsghdr) std::array<char, 128> control{};
  sockaddr_ll from{};
  iovec data{bytes.data(), bytes.size()};
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof from;
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = recvmsg(socket, &message, 0);
  if (size < ip_header || from.sll_protocol != htons(ETH_P_IP)) return std::nullopt;
  return TappedPacket{
      time_in(message), from.sll_pkttype == PACKET_OUTGOING, {bytes.begin(), bytes.begin() + size}};
}

}  // namespace

PacketTap::PacketTap(pid_t process, const std::string& interface)
    : socket_(open_there(process, interface)) {
  if (socket_ < 0) return;
  const timeval timeout{0, 20'000};
  const int on = 1;
  setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
  thread_ = std::thread([this] { run(); });
}

PacketTap::~PacketTap() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
  if (socket_ >= 0) close(socket_);
}

bool PacketTap::saw(const std::string& bytes) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(packets_.begin(), packets_.end(), [&](const TappedPacket& packet) {
    return std::search(packet.bytes.begin(), packet.bytes.end(), bytes.begin(), bytes.end()) !=
           packet.bytes.end();
  });
}

std::size_t PacketTap::multicasts() const {
  constexpr std::size_t destination = 16;
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(packets_.begin(), packets_.end(), [](const TappedPacket& packet) {
        return !packet.outgoing && (packet.bytes[destination] & 0xF0U) == 0xE0U;
      }));
}

std::vector<TappedPacket> PacketTap::packets() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return packets_;
}

void PacketTap::run() {
  while (!stopping_) {
    auto packet = receive(socket_);
    if (!packet) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    packets_.push_back(std::move(*packet));
  }
}

}  // namespace tocsin
