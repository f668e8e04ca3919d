// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "foundation/time.hpp"

namespace tocsin::network {

/// An echo reply of ours.
struct EchoReply {
  std::uint16_t sequence = 0;
  Time received_at{};  ///< the kernel's receive stamp; the time of reading when it gave none
};

/// What became of an attempt to send.
struct SendResult {
  Time at{};      ///< when the packet was handed to the kernel
  int error = 0;  ///< errno (ENETUNREACH, ENOBUFS, ...); 0 when sent
};

/// Sends ICMPv4 echo requests to one address, and reads the replies. Never blocks, and throws from
/// the constructor only. Datagram socket when net.ipv4.ping_group_range allows it, else raw.
class IcmpSocket {
 public:
  /// `target` is a dotted IPv4 address: ConfigError otherwise. EnvironmentError when the process
  /// may open neither kind of socket. `payload_bytes` is that of `ping -s`.
  IcmpSocket(const std::string& target, std::size_t payload_bytes);
  ~IcmpSocket();
  IcmpSocket(const IcmpSocket&) = delete;
  IcmpSocket& operator=(const IcmpSocket&) = delete;

  [[nodiscard]] SendResult send(std::uint16_t sequence);

  /// The next reply to a request of this socket; empty when there is none. Everything else that
  /// arrives (other processes' replies, damaged packets) is skipped.
  [[nodiscard]] std::optional<EchoReply> receive();

  /// Readable when a reply may be waiting.
  [[nodiscard]] int fd() const { return fd_; }
  [[nodiscard]] bool is_raw() const { return raw_; }

 private:
  void open_datagram();
  void open_raw();
  void identify();

  int fd_ = -1;
  bool raw_ = false;
  sockaddr_in target_{};
  std::size_t payload_bytes_;
  std::uint16_t id_ = 0;
  std::uint64_t token_ = 0;
};

}  // namespace tocsin::network
