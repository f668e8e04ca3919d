// SPDX-License-Identifier: Apache-2.0
#include "transport/host_multicast.hpp"

#include <arpa/inet.h>
#include <linux/filter.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "transport/announcement_crowd.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {
namespace {

in_addr group_address() {
  in_addr address{};
  inet_pton(AF_INET, discovery_group, &address);
  return address;
}

sockaddr_in group_at(std::uint16_t port) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(port);
  at.sin_addr = group_address();
  return at;
}

unsigned loopback_index() { return if_nametoindex("lo"); }

ip_mreqn membership_on(unsigned interface) {
  ip_mreqn membership{};
  membership.imr_multiaddr = group_address();
  membership.imr_ifindex = static_cast<int>(interface);
  return membership;
}

template <class Value>
bool set(const FileDescriptor& socket, int level, int option, const Value& value) {
  return ::setsockopt(socket.get(), level, option, &value, sizeof value) == 0;
}

/// Lets pass what comes by loopback, and what the kernel has looped back from another interface:
/// that is how a host hears its own multicast. Anything else is from another machine, whatever its
/// source address says.
bool hear_this_host_only(const FileDescriptor& socket, unsigned loopback) {
  const auto ancillary = [](int what) { return static_cast<std::uint32_t>(SKF_AD_OFF + what); };
  std::array<sock_filter, 6> program{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, ancillary(SKF_AD_IFINDEX)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, loopback, 2, 0),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, ancillary(SKF_AD_PKTTYPE)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, PACKET_LOOPBACK, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, datagram_room),
      BPF_STMT(BPF_RET | BPF_K, 0),
  }};
  const sock_fprog filter{program.size(), program.data()};
  return set(socket, SOL_SOCKET, SO_ATTACH_FILTER, filter);
}

std::string text_of(const char* path) {
  const std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Datagram {
  const std::uint8_t* bytes;
  std::size_t size;
};

/// The interface is that of this datagram alone: other threads send by the socket, too.
void send_by(const FileDescriptor& socket, unsigned interface, Datagram what, sockaddr_in to) {
  iovec content{const_cast<std::uint8_t*>(what.bytes), what.size};
  alignas(cmsghdr) std::array<std::uint8_t, CMSG_SPACE(sizeof(in_pktinfo))> ancillary{};
  msghdr message{};
  message.msg_name = &to;
  message.msg_namelen = sizeof to;
  message.msg_iov = &content;
  message.msg_iovlen = 1;
  message.msg_control = ancillary.data();
  message.msg_controllen = ancillary.size();
  cmsghdr* const head = CMSG_FIRSTHDR(&message);
  head->cmsg_level = IPPROTO_IP;
  head->cmsg_type = IP_PKTINFO;
  head->cmsg_len = CMSG_LEN(sizeof(in_pktinfo));
  in_pktinfo by{};
  by.ipi_ifindex = static_cast<int>(interface);
  std::memcpy(CMSG_DATA(head), &by, sizeof by);
  (void)::sendmsg(socket.get(), &message, MSG_DONTWAIT);
}

}  // namespace

std::vector<unsigned> interfaces_with_member(const std::string& text, in_addr group,
                                             unsigned loopback) {
  std::vector<unsigned> found;
  std::istringstream lines(text);
  unsigned interface = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (line.empty() || !(words >> word)) continue;
    if (line.front() != '\t') {  // "2  eth0  :  2  V3"; the heading has no number
      interface = static_cast<unsigned>(std::strtoul(word.c_str(), nullptr, 10));
    } else if (std::strtoul(word.c_str(), nullptr, 16) == group.s_addr && interface != loopback) {
      found.push_back(interface);
    }
  }
  return found;
}

HostMulticastReceiver::HostMulticastReceiver(std::uint16_t port)
    : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_in at = group_at(port);
  const unsigned loopback = loopback_index();
  if (!hear_this_host_only(socket_, loopback) || !set(socket_, SOL_SOCKET, SO_REUSEADDR, 1) ||
      ::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0 ||
      !set(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, membership_on(loopback))) {
    throw EnvironmentError(std::string("UDP ") + discovery_group + ":" + std::to_string(port) +
                           ", where participants announce themselves, cannot be listened to: " +
                           std::generic_category().message(errno));
  }
}

void HostMulticastReceiver::start(OnDatagram on_datagram) {
  thread_ = std::thread([this, heard = std::move(on_datagram)] {
    AnnouncementCrowd crowd;
    receive_datagrams(socket_, stopping_, heard,
                      [&] { return crowd.on_announcement(std::chrono::steady_clock::now()); });
  });
  pthread_setname_np(thread_.native_handle(), "dds_multicast");
}

void HostMulticastReceiver::stop() {
  if (!thread_.joinable()) return;
  stopping_ = true;
  (void)::shutdown(socket_.get(), SHUT_RD);  // wakes the thread
  thread_.join();
}

HostMulticastSender::HostMulticastSender(const FileDescriptor& socket)
    : socket_(socket), loopback_(loopback_index()) {
  constexpr unsigned char this_host = 0;
  if (set(socket_, IPPROTO_IP, IP_MULTICAST_TTL, this_host)) return;
  throw EnvironmentError("announcements cannot be kept on this host: " +
                         std::generic_category().message(errno));
}

void HostMulticastSender::send(const std::uint8_t* bytes, std::size_t size, std::uint16_t port) {
  const sockaddr_in to = group_at(port);
  const std::string members = text_of("/proc/net/igmp");
  for (const unsigned interface : interfaces_with_member(members, to.sin_addr, loopback_)) {
    send_by(socket_, interface, {bytes, size}, to);
  }
}

}  // namespace tocsin
