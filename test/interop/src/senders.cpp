// SPDX-License-Identifier: Apache-2.0
#include "senders.hpp"

#include <netinet/in.h>

#include <cstring>

namespace tocsin::interop {
namespace {

std::string sender_of(const std::vector<std::uint8_t>& packet) {
  constexpr std::size_t protocol_at = 9;
  constexpr std::size_t udp_header_bytes = 8;
  constexpr std::size_t vendor_at = 6;  // RTPS 2.2 section 9.4.4
  const std::size_t rtps = (packet[0] & 0x0fU) * 4 + udp_header_bytes;
  if (packet[protocol_at] == IPPROTO_IGMP) return "igmp";
  if (packet[protocol_at] != IPPROTO_UDP || packet.size() < rtps + vendor_at + 2 ||
      std::memcmp(packet.data() + rtps, "RTPS", 4) != 0) {
    return "ip " + std::to_string(packet[protocol_at]);
  }
  return std::to_string(packet[rtps + vendor_at]) + "." +
         std::to_string(packet[rtps + vendor_at + 1]);
}

}  // namespace

std::vector<std::string> senders(const PacketTap& tap) {
  std::vector<std::string> all;
  for (const TappedPacket& packet : tap.packets()) {
    if (!packet.outgoing) all.push_back(sender_of(packet.bytes));
  }
  return all;
}

}  // namespace tocsin::interop
