// SPDX-License-Identifier: Apache-2.0
#include "runtime/testing/forger.hpp"

#include <arpa/inet.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <netinet/ip.h>
#include <netinet/udp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

constexpr std::size_t prefix_at = 8;
constexpr std::size_t prefix_bytes = 12;

/// Where the value of a parameter begins in an announcement; its end when there is none.
Forger::Packet::iterator value_of(Forger::Packet& packet, std::uint8_t id, std::uint8_t bytes) {
  const std::array<std::uint8_t, 4> head{id, 0, bytes, 0};
  const auto found = std::search(packet.begin(), packet.end(), head.begin(), head.end());
  return found == packet.end() ? found : found + head.size();
}

void set_lease(Forger::Packet& packet, std::uint32_t lease_s) {
  const auto lease = value_of(packet, 0x02, 8);
  if (lease != packet.end()) std::memcpy(&*lease, &lease_s, sizeof lease_s);
}

/// The place of the DATA's number, whose low word, little endian, is above all that were sent.
void set_high_number(Forger::Packet& packet) {
  constexpr std::array<std::uint8_t, 8> writer_and_high{0, 1, 0, 0xc2, 0, 0, 0, 0};
  const auto found =
      std::search(packet.begin(), packet.end(), writer_and_high.begin(), writer_and_high.end());
  if (found != packet.end()) *(found + writer_and_high.size() + 2) = 1;
}

}  // namespace

Forger::Forger(int link_domain, const Way& way)
    : link_domain_(link_domain),
      from_(inet_addr(way.from.c_str())),
      to_(inet_addr(way.to.c_str())),
      raw_(::socket(AF_INET, SOCK_RAW, IPPROTO_RAW)),
      // Of a host's own packets only who wants all protocols is told.
      capture_(::socket(AF_PACKET, SOCK_DGRAM, htons(from_ == to_ ? ETH_P_IP : ETH_P_ALL))),
      own_(::socket(AF_INET, SOCK_DGRAM, 0)) {
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof own;
  (void)::bind(own_, reinterpret_cast<const sockaddr*>(&own), sizeof own);
  (void)::getsockname(own_, reinterpret_cast<sockaddr*>(&own), &size);
  port_ = ntohs(own.sin_port);
  if (from_ == to_) {
    sockaddr_ll loopback{};
    loopback.sll_family = AF_PACKET;
    loopback.sll_protocol = htons(ETH_P_IP);
    loopback.sll_ifindex = static_cast<int>(if_nametoindex("lo"));
    (void)::bind(capture_, reinterpret_cast<const sockaddr*>(&loopback), sizeof loopback);
  }
  const timeval patience{0, 100'000};
  (void)::setsockopt(capture_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
}

Forger::~Forger() {
  if (raw_ >= 0) ::close(raw_);
  if (capture_ >= 0) ::close(capture_);
  ::close(own_);
}

std::optional<Forger::Overheard> Forger::receive() const {
  constexpr std::size_t headers = sizeof(iphdr) + sizeof(udphdr);
  const int first_port = 7400 + 250 * link_domain_;
  std::array<std::uint8_t, 4096> bytes{};
  const ssize_t size = ::recv(capture_, bytes.data(), bytes.size(), 0);
  if (size < static_cast<ssize_t>(headers + prefix_at + prefix_bytes)) return std::nullopt;
  iphdr ip{};
  std::memcpy(&ip, bytes.data(), sizeof ip);
  udphdr udp{};
  std::memcpy(&udp, bytes.data() + sizeof(iphdr), sizeof udp);
  const int port = ntohs(udp.dest);
  const bool on_link = port >= first_port && port < first_port + 250;
  if (ip.protocol != IPPROTO_UDP || ip.saddr != from_ || !on_link) return std::nullopt;
  return Overheard{ntohs(udp.source), Packet(bytes.data() + headers, bytes.data() + size)};
}

std::optional<Forger::Overheard> Forger::overhear(const std::string& host) const {
  const std::string name = host + "_link_router";
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < end) {
    auto heard = receive();
    if (!heard) continue;
    Packet& packet = heard->announcement;
    const bool named =
        std::search(packet.begin(), packet.end(), name.begin(), name.end()) != packet.end();
    if (named && value_of(packet, 0x50, 16) != packet.end()) return heard;
  }
  return std::nullopt;
}

std::vector<Forger::Overheard> Forger::overhear_all() const {
  std::vector<Overheard> all;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
  while (std::chrono::steady_clock::now() < end) {
    if (auto heard = receive()) all.push_back(std::move(*heard));
  }
  return all;
}

void Forger::send(const Packet& packet, std::uint16_t from) const {
  for (const int offset :
       {10, 11, 12, 13, 14, 15}) {  // of three participants, for both kinds of traffic
    iphdr ip{};
    ip.version = 4;
    ip.ihl = sizeof ip / 4;
    ip.ttl = 64;
    ip.protocol = IPPROTO_UDP;
    ip.saddr = from_;
    ip.daddr = to_;
    udphdr udp{};
    udp.source = htons(from);
    udp.dest = htons(static_cast<std::uint16_t>(7400 + 250 * link_domain_ + offset));
    udp.len = htons(static_cast<std::uint16_t>(sizeof udp + packet.size()));
    Packet whole(sizeof ip + sizeof udp);
    std::memcpy(whole.data(), &ip, sizeof ip);
    std::memcpy(whole.data() + sizeof ip, &udp, sizeof udp);
    whole.insert(whole.end(), packet.begin(), packet.end());
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = to_;
    (void)::sendto(raw_, whole.data(), whole.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                   sizeof to);
  }
}

Forger::Packet Forger::departure_of(const Overheard& victim) {
  constexpr std::size_t header = prefix_at + prefix_bytes;
  const auto prefix = victim.announcement.begin() + prefix_at;
  Packet packet(victim.announcement.begin(), victim.announcement.begin() + header);
  const auto add = [&](std::initializer_list<std::uint8_t> octets) {
    packet.insert(packet.end(), octets);
  };
  add({0x15, 3, 0, 0, 0, 0, 16, 0, 0, 1, 0, 0xc7, 0, 1, 0, 0xc2, 0, 0, 0, 0, 0, 0, 2, 0});
  add({0x71, 0, 4, 0, 0, 0, 0, 3, 0x70, 0, 16, 0});
  packet.insert(packet.end(), prefix, prefix + prefix_bytes);
  add({0, 0, 1, 0xc1, 1, 0, 0, 0});
  return packet;
}

Forger::Packet Forger::with_lease(const Overheard& victim, std::uint32_t lease_s) {
  Packet packet = victim.announcement;
  set_lease(packet, lease_s);
  set_high_number(packet);
  return packet;
}

Forger::Packet Forger::stranger_like(const Overheard& victim, std::uint32_t number) {
  constexpr std::uint32_t endless = 0x7fffffff;
  Packet packet = with_lease(victim, endless);
  const auto guid = value_of(packet, 0x50, 16);
  for (std::uint8_t* const place : {packet.data() + prefix_at, &*guid}) {
    std::memcpy(place + prefix_bytes - sizeof number, &number, sizeof number);
  }
  return packet;
}

Forger::Packet Forger::exaggerated(const Packet& message, std::uint32_t by) {
  constexpr std::uint8_t data = 0x15;
  constexpr std::size_t number_at = 2 + 2 + 4 + 4 + 4;  // its low word: behind both entities
  constexpr std::size_t end_bytes = 16;
  Packet packet = message;
  Submessages all(message.data(), message.size());
  while (const auto one = all.next()) {
    if (one->kind != data || one->bytes <= number_at + 4 + 24) continue;
    std::uint8_t* const content = packet.data() + (one->content - message.data());
    std::uint32_t low = 0;
    std::memcpy(&low, content + number_at, sizeof low);
    low += by;
    std::memcpy(content + number_at, &low, sizeof low);
    std::fill_n(content + one->bytes - end_bytes, end_bytes, 0xff);
  }
  return packet;
}

}  // namespace tocsin
