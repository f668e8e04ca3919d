// SPDX-License-Identifier: Apache-2.0
#include "clock_offset.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "foundation/file_descriptor.hpp"

namespace tocsin::doctor {
namespace {

constexpr std::uint8_t request_type = 13;
constexpr std::uint8_t reply_type = 14;
constexpr std::int64_t day_ms = 86'400'000;

std::uint32_t big_endian(const std::uint8_t* b) {
  return static_cast<std::uint32_t>(b[0]) << 24U | static_cast<std::uint32_t>(b[1]) << 16U |
         static_cast<std::uint32_t>(b[2]) << 8U | static_cast<std::uint32_t>(b[3]);
}

/// RFC 1071.
std::uint16_t checksum(const IcmpTimestamp& bytes) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    sum += static_cast<std::uint32_t>(bytes[i] << 8U | bytes[i + 1]);
  }
  while (sum > 0xFFFF) sum = (sum & 0xFFFF) + (sum >> 16U);
  return static_cast<std::uint16_t>(~sum);
}

/// a - b on a clock that wraps at midnight.
double difference_ms(std::uint32_t a, std::uint32_t b) {
  std::int64_t difference = (static_cast<std::int64_t>(a) - b) % day_ms;
  if (difference > day_ms / 2) difference -= day_ms;
  if (difference < -day_ms / 2) difference += day_ms;
  return static_cast<double>(difference);
}

std::uint32_t now_ms() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(since).count();
  return static_cast<std::uint32_t>(ms % day_ms);
}

/// The first reply that comes within a second.
std::optional<double> wait_for_reply(int descriptor, std::uint16_t id) {
  constexpr int timeout_ms = 1000;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
  std::array<std::uint8_t, 256> packet{};
  pollfd waiting{descriptor, POLLIN, 0};
  while (std::chrono::steady_clock::now() < end && ::poll(&waiting, 1, timeout_ms) > 0) {
    const ssize_t size = ::recv(descriptor, packet.data(), packet.size(), 0);
    const std::size_t header = 4U * (packet[0] & 0x0FU);
    if (size < 0 || static_cast<std::size_t>(size) <= header) continue;
    const auto ahead = clock_ahead_ms(packet.data() + header,
                                      static_cast<std::size_t>(size) - header, id, now_ms());
    if (ahead) return ahead;
  }
  return std::nullopt;
}

}  // namespace

IcmpTimestamp timestamp_request(std::uint16_t id, std::uint32_t sent_ms) {
  IcmpTimestamp bytes{};
  bytes[0] = request_type;
  bytes[4] = static_cast<std::uint8_t>(id >> 8U);
  bytes[5] = static_cast<std::uint8_t>(id);
  for (unsigned i = 0; i < 4; ++i) {
    bytes[8 + i] = static_cast<std::uint8_t>(sent_ms >> (24U - 8U * i));
  }
  const std::uint16_t sum = checksum(bytes);
  bytes[2] = static_cast<std::uint8_t>(sum >> 8U);
  bytes[3] = static_cast<std::uint8_t>(sum);
  return bytes;
}

std::optional<double> clock_ahead_ms(const std::uint8_t* icmp, std::size_t size, std::uint16_t id,
                                     std::uint32_t received_ms) {
  constexpr std::uint32_t not_standard = 0x80000000U;  // RFC 792: no UTC to be had
  if (size < IcmpTimestamp{}.size() || icmp[0] != reply_type) return std::nullopt;
  if ((icmp[4] << 8U | icmp[5]) != id) return std::nullopt;
  const std::uint32_t sent = big_endian(icmp + 8);
  const std::uint32_t there = big_endian(icmp + 12);
  const std::uint32_t back = big_endian(icmp + 16);
  if (((there | back) & not_standard) != 0) return std::nullopt;
  return (difference_ms(there, sent) + difference_ms(back, received_ms)) / 2;
}

Advice judge_clock(const std::string& peer, double ahead_ms) {
  constexpr double tolerable_ms = 20;
  char text[120];
  std::snprintf(text, sizeof text, "clock of %s is %.0f ms %s ours", peer.c_str(),
                std::abs(ahead_ms), ahead_ms < 0 ? "behind" : "ahead of");
  if (std::abs(ahead_ms) <= tolerable_ms) return {Fitness::good, text, ""};
  return {Fitness::bad, std::string(text) + ": latencies between the hosts are wrong by that much",
          "synchronise both with chrony or ptp4l"};
}

Advice compare_clock(const std::string& peer) {
  const FileDescriptor socket(::socket(AF_INET, SOCK_RAW | SOCK_CLOEXEC, IPPROTO_ICMP));
  if (!socket) {
    return {Fitness::unknown, "clock of " + peer + ": not compared, needs root", ""};
  }
  sockaddr_in to{};
  to.sin_family = AF_INET;
  ::inet_pton(AF_INET, peer.c_str(), &to.sin_addr);
  const auto id = static_cast<std::uint16_t>(::getpid());
  const IcmpTimestamp request = timestamp_request(id, now_ms());
  if (::sendto(socket.get(), request.data(), request.size(), 0,
               reinterpret_cast<const sockaddr*>(&to), sizeof to) < 0) {
    return {Fitness::bad, "peer " + peer + ": " + std::strerror(errno), "is the radio up?"};
  }
  const auto ahead = wait_for_reply(socket.get(), id);
  if (ahead) return judge_clock(peer, *ahead);
  return {Fitness::bad, "peer " + peer + " does not answer within 1 s",
          "is it on, in reach, and free to answer ICMP timestamps?"};
}

}  // namespace tocsin::doctor
