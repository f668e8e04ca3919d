// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/rtps_capture.hpp"

#include <arpa/inet.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <utility>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

constexpr char mark[20] = "tocsin capture mark";

std::uint32_t big32(const std::uint8_t* p) {
  return static_cast<std::uint32_t>(p[0]) << 24U | static_cast<std::uint32_t>(p[1]) << 16U |
         static_cast<std::uint32_t>(p[2]) << 8U | p[3];
}

/// How the submessage begins: its kind, flags, and the 56 bytes that follow.
constexpr std::uint8_t statistics[]{0x80, 0x01, 0x38, 0x00};

/// Offset of the writer entity id behind the submessage header, 0 when it has none of interest.
std::size_t writer_offset(std::uint8_t kind) {
  switch (kind) {
    case 0x15:
    case 0x16:
      return 8;  // extraFlags, octetsToInlineQos, readerId
    case 0x07:
    case 0x06:
      return 4;  // readerId
    default:
      return 0;
  }
}

}  // namespace

RtpsCapture::RtpsCapture() : socket_(socket(AF_PACKET, SOCK_DGRAM, htons(ETH_P_IP))) {
  if (socket_ < 0) return;
  sockaddr_ll loopback{};
  loopback.sll_family = AF_PACKET;
  loopback.sll_protocol = htons(ETH_P_IP);
  loopback.sll_ifindex = static_cast<int>(if_nametoindex("lo"));
  const timeval timeout{0, 20'000};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
  if (bind(socket_, reinterpret_cast<const sockaddr*>(&loopback), sizeof loopback) != 0) {
    close(socket_);
    socket_ = -1;
    return;
  }
  thread_ = std::thread([this] { run(); });
}

RtpsCapture::~RtpsCapture() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
  if (socket_ >= 0) close(socket_);
}

/// Packets are captured in the order in which they are sent, so what was sent before a mark has
/// been read when the mark has.
void RtpsCapture::wait_for_own_mark() {
  const int sender = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(9);  // discard
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const auto* address = reinterpret_cast<const sockaddr*>(&to);
  (void)sendto(sender, mark, sizeof mark, 0, address, sizeof to);
  close(sender);
  ++marks_sent_;
  while (marks_seen_ < marks_sent_) std::this_thread::yield();
}

std::vector<CapturedSubmessage> RtpsCapture::take() {
  wait_for_own_mark();
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(seen_, {});
}

void RtpsCapture::run() {
  std::array<std::uint8_t, 65536> packet{};
  while (!stopping_) {
    sockaddr_ll from{};
    socklen_t length = sizeof from;
    const ssize_t size = recvfrom(socket_, packet.data(), packet.size(), 0,
                                  reinterpret_cast<sockaddr*>(&from), &length);
    if (size > 0 && from.sll_pkttype != PACKET_OUTGOING) {  // loopback shows every packet twice
      parse(packet.data(), static_cast<std::size_t>(size));
    }
  }
}

void RtpsCapture::parse(const std::uint8_t* packet, std::size_t size) {
  const std::size_t ip = static_cast<std::size_t>(packet[0] & 0x0FU) * 4;
  constexpr std::size_t udp = 8;
  constexpr std::size_t rtps_header = 20;
  if (size < ip + udp + rtps_header || packet[9] != IPPROTO_UDP) return;
  const std::uint8_t* rtps = packet + ip + udp;
  if (std::memcmp(rtps, mark, sizeof mark) == 0) ++marks_seen_;
  if (std::memcmp(rtps, "RTPS", 4) != 0) return;
  CapturedSubmessage common{};
  common.port = static_cast<std::uint16_t>(packet[ip + 2] << 8U | packet[ip + 3]);
  common.packet_bytes = static_cast<std::uint32_t>(size);
  common.dscp = packet[1] >> 2U;
  common.statistics =
      size > 60 && std::memcmp(packet + size - 60, statistics, sizeof statistics) == 0;
  note(rtps, size - ip - udp, common);
}

void RtpsCapture::note(const std::uint8_t* message, std::size_t size, CapturedSubmessage common) {
  Submessages all(message, size);
  while (const auto one = all.next()) {
    const std::size_t offset = writer_offset(one->kind);
    if (offset == 0 || one->bytes < offset + 4) continue;
    common.kind = one->kind;
    common.writer = big32(one->content + offset);
    const std::lock_guard<std::mutex> lock(mutex_);
    seen_.push_back(common);
  }
}

}  // namespace tocsin
