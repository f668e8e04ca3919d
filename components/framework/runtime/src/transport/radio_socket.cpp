// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_socket.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>

#include <array>
#include <cstring>
#include <utility>

namespace tocsin {

namespace rtps = eprosima::fastdds::rtps;

std::uint32_t ipv4_of(const rtps::Locator_t& locator) {
  in_addr address{};
  std::memcpy(&address, rtps::IPLocator::getIPv4(locator), sizeof address);
  return ntohl(address.s_addr);
}

FileDescriptor radio_socket(const std::string& address, std::uint16_t port) {
  FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_port = htons(port);
  const int free = 1;
  const bool bound = socket && inet_pton(AF_INET, address.c_str(), &own.sin_addr) == 1 &&
                     ::setsockopt(socket.get(), IPPROTO_IP, IP_FREEBIND, &free, sizeof free) == 0 &&
                     ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
  return bound ? std::move(socket) : FileDescriptor{};
}

bool RadioSocket::send(const std::uint8_t* bytes, std::size_t size, const rtps::Locator_t& to,
                       int dscp, const std::vector<std::uint8_t>& more) const {
  sockaddr_in peer{};
  peer.sin_family = AF_INET;
  peer.sin_port = htons(rtps::IPLocator::getPhysicalPort(to));
  std::memcpy(&peer.sin_addr, rtps::IPLocator::getIPv4(to), sizeof peer.sin_addr);
  std::array<iovec, 2> data{{{const_cast<rtps::octet*>(bytes), size},
                             {const_cast<rtps::octet*>(more.data()), more.size()}}};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};
  message.msg_name = &peer;
  message.msg_namelen = sizeof peer;
  message.msg_iov = data.data();
  message.msg_iovlen = more.empty() ? 1 : 2;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = IPPROTO_IP;
  header->cmsg_type = IP_TOS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  const int tos = dscp << 2;  // the lower two bits are ECN (RFC 3168)
  std::memcpy(CMSG_DATA(header), &tos, sizeof tos);
  const auto whole = static_cast<ssize_t>(size + more.size());
  return ::sendmsg(socket_.get(), &message, MSG_DONTWAIT) == whole;
}

}  // namespace tocsin
