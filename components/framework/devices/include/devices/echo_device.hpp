// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "devices/device.hpp"
#include "foundation/time.hpp"

namespace tocsin {

/// The echo requests of one device.
struct EchoTarget {
  std::string address;            ///< IPv4, dotted
  std::size_t payload_bytes = 0;  ///< that of `ping -s`; a packet has 28 more
  std::uint8_t dscp = 0;          ///< of requests, 0 to 63; most hosts' replies have the same
};

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

/// Sends echo requests to one host and takes its replies. Opening throws ConfigError when the
/// target is no IPv4 address, EnvironmentError when this process may not send. Nothing else blocks
/// or throws.
class EchoDevice : public Device {
 public:
  static constexpr const char* kind = "echo target";
  using Address = EchoTarget;
  [[nodiscard]] static std::string text(const EchoTarget& target) { return target.address; }

  [[nodiscard]] virtual SendResult send(std::uint16_t /*sequence*/) { return {{}, ENETUNREACH}; }
  /// The next reply to a request of this device; empty when there is none.
  [[nodiscard]] virtual std::optional<EchoReply> receive() { return std::nullopt; }
};

}  // namespace tocsin
