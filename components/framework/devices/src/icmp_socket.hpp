// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "devices/echo_device.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin::network {

/// Sends ICMPv4 echo requests to one address, and reads the replies. Never blocks, and throws from
/// the constructor only. Datagram socket when net.ipv4.ping_group_range allows it, else raw.
class IcmpSocket final : public EchoDevice {
 public:
  /// ConfigError when the address is not a dotted IPv4 address, EnvironmentError when the process
  /// may open neither kind of socket.
  explicit IcmpSocket(const EchoTarget& target);

  [[nodiscard]] SendResult send(std::uint16_t sequence) override;
  /// Everything that is not a reply to this socket (other processes' replies, damaged packets) is
  /// skipped.
  [[nodiscard]] std::optional<EchoReply> receive() override;
  [[nodiscard]] std::optional<int> descriptor() const override { return socket_.get(); }
  [[nodiscard]] bool is_raw() const { return raw_; }

 private:
  void open_datagram();
  void open_raw();
  void identify();

  FileDescriptor socket_;
  bool raw_ = false;
  sockaddr_in target_{};
  std::size_t payload_bytes_;
  std::uint16_t id_ = 0;
  std::uint64_t token_ = 0;
};

}  // namespace tocsin::network
