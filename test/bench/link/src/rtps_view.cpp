// SPDX-License-Identifier: Apache-2.0
#include "rtps_view.hpp"

#include <netinet/in.h>

#include <cstring>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

constexpr std::uint8_t data = 0x15;
constexpr std::uint8_t data_frag = 0x16;

template <class Number>
Number little(const std::uint8_t* at) {
  Number number;
  std::memcpy(&number, at, sizeof number);
  return number;
}

/// The parameters of inline QoS begin at `at`; where they end.
std::size_t after_parameters(const Submessage& one, std::size_t at) {
  constexpr std::uint16_t sentinel = 1;
  while (at + 4 <= one.bytes) {
    const auto id = little<std::uint16_t>(one.content + at);
    const auto length = little<std::uint16_t>(one.content + at + 2);
    at += 4U + length;
    if (id == sentinel) break;
  }
  return at;
}

std::optional<SamplePart> part_of(const Submessage& one) {
  constexpr std::size_t fixed = 20;  // flags, octets to inline QoS, reader, writer, number
  constexpr std::size_t fragmented = 32;
  constexpr std::uint8_t has_inline_qos = 2;
  const bool is_fragment = one.kind == data_frag;
  if (one.bytes < (is_fragment ? fragmented : fixed) || (one.flags & 1U) == 0) return std::nullopt;
  SamplePart part;
  for (std::size_t i = 8; i < 12; ++i) part.writer = part.writer << 8U | one.content[i];
  part.number = static_cast<std::int64_t>(little<std::uint32_t>(one.content + 12)) << 32U |
                little<std::uint32_t>(one.content + 16);
  if (is_fragment) {
    const auto first = little<std::uint32_t>(one.content + 20);
    const auto count = little<std::uint16_t>(one.content + 24);
    const auto size = little<std::uint16_t>(one.content + 26);
    const auto whole = little<std::uint32_t>(one.content + 28);
    part.first = first == 1;
    part.last = std::uint64_t{first - 1 + count} * size >= whole;
  }
  std::size_t at = 4U + little<std::uint16_t>(one.content + 2);
  if ((one.flags & has_inline_qos) != 0) at = after_parameters(one, at);
  if (at > one.bytes) return std::nullopt;
  part.payload = one.content + at;
  part.bytes = one.bytes - at;
  return part;
}

}  // namespace

std::optional<RtpsPacket> rtps_in(const std::vector<std::uint8_t>& packet) {
  constexpr std::size_t udp = 8;
  if (packet.size() < 20) return std::nullopt;
  const std::size_t ip = (packet[0] & 0x0FU) * 4U;
  const bool later_fragment = ((packet[6] & 0x1FU) | packet[7]) != 0;
  if (packet[9] != IPPROTO_UDP || later_fragment || packet.size() < ip + udp + 20) {
    return std::nullopt;
  }
  RtpsPacket view;
  view.destination_port = static_cast<std::uint16_t>(packet[ip + 2] << 8U | packet[ip + 3]);
  view.message = packet.data() + ip + udp;
  view.bytes = packet.size() - ip - udp;
  if (std::memcmp(view.message, "RTPS", 4) != 0) return std::nullopt;
  return view;
}

std::vector<SamplePart> samples_in(const RtpsPacket& packet) {
  std::vector<SamplePart> parts;
  Submessages all(packet.message, packet.bytes);
  while (const auto one = all.next()) {
    if (one->kind != data && one->kind != data_frag) continue;
    if (const auto part = part_of(*one)) parts.push_back(*part);
  }
  return parts;
}

}  // namespace tocsin
