// SPDX-License-Identifier: Apache-2.0
#include "icmp_packet.hpp"

#include <cassert>

namespace tocsin::network {
namespace {

constexpr std::uint8_t echo_reply = 0;    // RFC 792
constexpr std::uint8_t echo_request = 8;  // RFC 792
constexpr std::size_t header_bytes = 8;

std::uint16_t get_u16(const std::uint8_t* at) {
  return static_cast<std::uint16_t>((at[0] << 8) | at[1]);
}

void put_u16(std::uint8_t* at, std::uint16_t value) {
  at[0] = static_cast<std::uint8_t>(value >> 8);
  at[1] = static_cast<std::uint8_t>(value & 0xff);
}

std::uint64_t get_u64(const std::uint8_t* at) {
  std::uint64_t value = 0;
  for (int i = 0; i < 8; ++i) value = (value << 8) | at[i];
  return value;
}

void put_u64(std::uint8_t* at, std::uint64_t value) {
  for (int i = 7; i >= 0; --i, value >>= 8) at[i] = static_cast<std::uint8_t>(value & 0xff);
}

}  // namespace

std::uint16_t internet_checksum(const std::uint8_t* data, std::size_t size) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i + 1 < size; i += 2) sum += get_u16(data + i);
  if (size % 2 == 1) sum += static_cast<std::uint32_t>(data[size - 1]) << 8;
  while (sum > 0xffff) sum = (sum & 0xffff) + (sum >> 16);
  return static_cast<std::uint16_t>(~sum);
}

std::vector<std::uint8_t> encode_echo_request(const Echo& echo, std::size_t payload_bytes) {
  assert(payload_bytes >= min_echo_payload);
  std::vector<std::uint8_t> packet(header_bytes + payload_bytes);
  packet[0] = echo_request;
  put_u16(&packet[4], echo.id);
  put_u16(&packet[6], echo.sequence);
  put_u64(&packet[header_bytes], echo.token);
  for (std::size_t i = header_bytes + min_echo_payload; i < packet.size(); ++i) {
    packet[i] = static_cast<std::uint8_t>(i);
  }
  put_u16(&packet[2], internet_checksum(packet.data(), packet.size()));
  return packet;
}

std::optional<Echo> decode_echo_reply(const std::uint8_t* data, std::size_t size) {
  if (size < header_bytes + min_echo_payload) return std::nullopt;
  if (data[0] != echo_reply || data[1] != 0) return std::nullopt;
  if (internet_checksum(data, size) != 0) return std::nullopt;
  return Echo{get_u16(data + 4), get_u16(data + 6), get_u64(data + header_bytes)};
}

std::optional<std::size_t> ipv4_header_size(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t smallest = 20;  // RFC 791
  if (size < smallest || (data[0] >> 4) != 4) return std::nullopt;
  const std::size_t length = std::size_t{4} * (data[0] & 0x0fU);
  if (length < smallest || length > size) return std::nullopt;
  return length;
}

}  // namespace tocsin::network
