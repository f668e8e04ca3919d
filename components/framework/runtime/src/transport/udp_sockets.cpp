// SPDX-License-Identifier: Apache-2.0
#include "transport/udp_sockets.hpp"

#include <linux/filter.h>
#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <linux/sock_diag.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

struct Request {
  nlmsghdr header;
  inet_diag_req_v2 body;
};

Request request_for(std::uint8_t family, std::uint16_t flags) {
  Request request{};
  request.header.nlmsg_len = sizeof request;
  request.header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
  request.header.nlmsg_flags = static_cast<std::uint16_t>(NLM_F_REQUEST | flags);
  request.body.sdiag_family = family;
  request.body.sdiag_protocol = IPPROTO_UDP;
  request.body.idiag_states = ~std::uint32_t{0};
  request.body.id.idiag_cookie[0] = request.body.id.idiag_cookie[1] = INET_DIAG_NOCOOKIE;
  return request;
}

bool is_sole(const inet_diag_msg& socket, const inet_diag_sockopt& options) {
  for (const std::uint32_t part : socket.id.idiag_src) {
    if (part != 0) return false;
  }
  return options.freebind != 0 && options.bind_address_no_port != 0 && options.mc_all == 0;
}

UdpSocket read_socket(const nlmsghdr& message) {
  const auto* const socket = static_cast<const inet_diag_msg*>(NLMSG_DATA(&message));
  UdpSocket found{socket->idiag_uid, false};
  const auto* attribute = reinterpret_cast<const rtattr*>(socket + 1);
  auto left = static_cast<int>(message.nlmsg_len - NLMSG_LENGTH(sizeof *socket));
  for (; RTA_OK(attribute, left); attribute = RTA_NEXT(attribute, left)) {
    inet_diag_sockopt options{};
    if (attribute->rta_type != INET_DIAG_SOCKOPT || RTA_PAYLOAD(attribute) < sizeof options) {
      continue;
    }
    std::memcpy(&options, RTA_DATA(attribute), sizeof options);
    found.is_sole = is_sole(*socket, options);
  }
  return found;
}

enum class Answer { more, complete, failed };

/// Adds what one part of the kernel's answer tells.
Answer read_part(const std::uint8_t* bytes, ssize_t size, UdpSockets::Found& found) {
  Answer answer = Answer::complete;
  auto left = static_cast<unsigned>(size);
  const auto* message = reinterpret_cast<const nlmsghdr*>(bytes);
  for (; NLMSG_OK(message, left); message = NLMSG_NEXT(message, left)) {
    if (message->nlmsg_type == NLMSG_DONE) return Answer::complete;
    if (message->nlmsg_type == NLMSG_ERROR) {
      const auto* const error = static_cast<const nlmsgerr*>(NLMSG_DATA(message));
      return error->error == -ENOENT ? Answer::complete : Answer::failed;
    }
    found.push_back(read_socket(*message));
    if ((message->nlmsg_flags & NLM_F_MULTI) != 0) answer = Answer::more;
  }
  return answer;
}

bool ask(const FileDescriptor& netlink, const Request& request, UdpSockets::Found& found) {
  alignas(nlmsghdr) std::array<std::uint8_t, 16'384> part;
  if (::send(netlink.get(), &request, sizeof request, 0) != sizeof request) return false;
  Answer answer = Answer::more;
  while (answer == Answer::more) {
    const ssize_t size = ::recv(netlink.get(), part.data(), part.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    answer = size <= 0 ? Answer::failed : read_part(part.data(), size, found);
  }
  return answer == Answer::complete;
}

bool switch_option(const FileDescriptor& socket, int option, int value) {
  return ::setsockopt(socket.get(), IPPROTO_IP, option, &value, sizeof value) == 0;
}

bool hear_nothing(const FileDescriptor& socket) {
  sock_filter drop = BPF_STMT(BPF_RET | BPF_K, 0);
  const sock_fprog filter{1, &drop};
  return ::setsockopt(socket.get(), SOL_SOCKET, SO_ATTACH_FILTER, &filter, sizeof filter) == 0;
}

/// Whatever comes meanwhile.
void wait_for_shutdown(const FileDescriptor& socket, Duration at_most) {
  pollfd shutdown{socket.get(), POLLRDHUP, 0};
  const auto whole = std::chrono::duration_cast<std::chrono::milliseconds>(at_most);
  (void)::poll(&shutdown, 1, static_cast<int>(whole.count()));
}

}  // namespace

UdpSockets::UdpSockets()
    : netlink_(::socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC, NETLINK_SOCK_DIAG)) {}

std::optional<UdpSockets::Found> UdpSockets::at(const sockaddr_in& place) {
  Request request = request_for(AF_INET, 0);
  // Of one socket the kernel takes the destination for the socket's own place.
  request.body.id.idiag_dst[0] = place.sin_addr.s_addr;
  request.body.id.idiag_dport = place.sin_port;
  Found found;
  if (!ask(netlink_, request, found)) return std::nullopt;
  return found;
}

std::optional<UdpSockets::Found> UdpSockets::with_port(std::uint16_t port) {
  Found found;
  if (!add_with_port(AF_INET, port, found) || !add_with_port(AF_INET6, port, found)) {
    return std::nullopt;
  }
  return found;
}

bool UdpSockets::add_with_port(std::uint8_t family, std::uint16_t port, Found& found) {
  Request request = request_for(family, NLM_F_DUMP);
  request.body.id.idiag_sport = htons(port);
  return ask(netlink_, request, found);
}

void receive_datagrams(const FileDescriptor& socket, const std::atomic<bool>& stopping,
                       const OnDatagram& on_datagram) {
  receive_datagrams(socket, stopping, on_datagram, [] { return Duration::zero(); });
}

void receive_datagrams(const FileDescriptor& socket, const std::atomic<bool>& stopping,
                       const OnDatagram& on_datagram, const std::function<Duration()>& pause) {
  std::vector<std::uint8_t> bytes(datagram_room);
  Duration let_come{0};
  while (!stopping) {
    sockaddr_in from{};
    socklen_t from_size = sizeof from;
    const ssize_t size = ::recvfrom(socket.get(), bytes.data(), bytes.size(),
                                    let_come > Duration::zero() ? MSG_DONTWAIT : 0,
                                    reinterpret_cast<sockaddr*>(&from), &from_size);
    if (size > 0) on_datagram(bytes.data(), static_cast<std::size_t>(size), from);
    if (size < 0 && let_come > Duration::zero()) wait_for_shutdown(socket, let_come);
    let_come = size < 0 ? Duration::zero() : pause();
  }
}

FileDescriptor sole_udp_socket() {
  FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in everywhere{};
  everywhere.sin_family = AF_INET;
  if (socket && hear_nothing(socket) &&
      ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&everywhere), sizeof everywhere) ==
          0 &&
      switch_option(socket, IP_FREEBIND, 1) && switch_option(socket, IP_MULTICAST_ALL, 0) &&
      switch_option(socket, IP_BIND_ADDRESS_NO_PORT, 1)) {
    return socket;
  }
  throw EnvironmentError("no UDP socket to send from: " + std::generic_category().message(errno));
}

}  // namespace tocsin
