// SPDX-License-Identifier: Apache-2.0
#include "icmp_socket.hpp"

#include <arpa/inet.h>
#include <linux/icmp.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <random>

#include "foundation/error.hpp"
#include "icmp_packet.hpp"

namespace tocsin::network {
namespace {

constexpr int flags = SOCK_NONBLOCK | SOCK_CLOEXEC;

sockaddr_in parse_target(const std::string& target) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  if (inet_pton(AF_INET, target.c_str(), &address.sin_addr) == 1) return address;
  throw ConfigError("probe target: '" + target + "' is not an IPv4 address such as 10.8.0.1");
}

Duration to_duration(const timespec& t) {
  return std::chrono::seconds{t.tv_sec} + std::chrono::nanoseconds{t.tv_nsec};
}

/// The instant on the monotonic clock of a stamp on the wall clock; `now` when the wall clock was
/// set in between.
Time monotonic(const timespec& stamp, Time now) {
  timespec wall{};
  clock_gettime(CLOCK_REALTIME, &wall);
  const Duration age = to_duration(wall) - to_duration(stamp);
  const bool plausible = age >= Duration{0} && age < std::chrono::seconds{60};
  return plausible ? now - age : now;
}

Time receive_time(msghdr& message) {
  const Time now = std::chrono::steady_clock::now();
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c; c = CMSG_NXTHDR(&message, c)) {
    if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec stamp{};
    std::memcpy(&stamp, CMSG_DATA(c), sizeof stamp);
    return monotonic(stamp, now);
  }
  return now;
}

/// The reply in a packet as the socket delivers it: raw sockets put the IP header before it.
std::optional<Echo> decode(const std::uint8_t* data, std::size_t size, bool raw) {
  if (!raw) return decode_echo_reply(data, size);
  const auto header = ipv4_header_size(data, size);
  return header ? decode_echo_reply(data + *header, size - *header) : std::nullopt;
}

}  // namespace

IcmpSocket::IcmpSocket(const EchoTarget& target)
    : target_(parse_target(target.address)),
      payload_bytes_(std::max(target.payload_bytes, min_echo_payload)) {
  open_datagram();
  if (!socket_) open_raw();
  const int on = 1;
  // Without the kernel's stamp the time of reading is used: no reason to fail.
  (void)setsockopt(socket_.get(), SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
  const int tos = target.dscp << 2;  // a kernel that refuses it costs the priority only
  (void)setsockopt(socket_.get(), IPPROTO_IP, IP_TOS, &tos, sizeof tos);
}

void IcmpSocket::open_datagram() {
  socket_.reset(socket(AF_INET, SOCK_DGRAM | flags, IPPROTO_ICMP));
  if (!socket_) return;
  sockaddr_in own{};
  own.sin_family = AF_INET;
  socklen_t size = sizeof own;
  // The kernel replaces the identifier of a request by this "port", and filters replies by it.
  const bool bound = bind(socket_.get(), reinterpret_cast<sockaddr*>(&own), size) == 0 &&
                     getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&own), &size) == 0;
  if (!bound) {
    socket_.reset();
    return;
  }
  identify();
  id_ = ntohs(own.sin_port);
}

void IcmpSocket::open_raw() {
  socket_.reset(socket(AF_INET, SOCK_RAW | flags, IPPROTO_ICMP));
  if (!socket_) {
    throw EnvironmentError(
        "ICMP echo needs a group of this process in net.ipv4.ping_group_range (sysctl -w "
        "net.ipv4.ping_group_range='0 2147483647'), or the capability CAP_NET_RAW: " +
        std::string(std::strerror(errno)));
  }
  raw_ = true;
  icmp_filter filter{};
  filter.data = ~(1U << ICMP_ECHOREPLY);
  (void)setsockopt(socket_.get(), SOL_RAW, ICMP_FILTER, &filter, sizeof filter);
  identify();
}

void IcmpSocket::identify() {
  std::random_device random;
  id_ = static_cast<std::uint16_t>(random());
  token_ = (std::uint64_t{random()} << 32) | random();
}

SendResult IcmpSocket::send(std::uint16_t sequence) {
  const auto packet = encode_echo_request({id_, sequence, token_}, payload_bytes_);
  SendResult result;
  result.at = std::chrono::steady_clock::now();
  const ssize_t sent = sendto(socket_.get(), packet.data(), packet.size(), 0,
                              reinterpret_cast<const sockaddr*>(&target_), sizeof target_);
  if (sent < 0) result.error = errno;
  return result;
}

std::optional<EchoReply> IcmpSocket::receive() {
  std::array<std::uint8_t, 2048> packet{};
  alignas(cmsghdr) std::array<std::uint8_t, 256> control{};
  for (;;) {
    iovec buffer{packet.data(), packet.size()};
    msghdr message{};
    message.msg_iov = &buffer;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t size = recvmsg(socket_.get(), &message, 0);
    if (size < 0) return std::nullopt;
    const auto echo = decode(packet.data(), static_cast<std::size_t>(size), raw_);
    if (!echo || echo->id != id_ || echo->token != token_) continue;
    return EchoReply{echo->sequence, receive_time(message)};
  }
}

}  // namespace tocsin::network
