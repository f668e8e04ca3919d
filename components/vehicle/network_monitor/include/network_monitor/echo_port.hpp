// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

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

/// What the prober needs of the world: a socket on the vehicle, a script in a component test.
/// Nothing here blocks or throws.
class EchoPort {
 public:
  virtual ~EchoPort() = default;
  [[nodiscard]] virtual SendResult send(std::uint16_t sequence) = 0;
  /// The next reply to a request of this port; empty when there is none.
  [[nodiscard]] virtual std::optional<EchoReply> receive() = 0;
  /// Readable when a reply may be waiting.
  [[nodiscard]] virtual int fd() const = 0;
};

}  // namespace tocsin::network
