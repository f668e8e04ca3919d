// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "foundation/time.hpp"

namespace tocsin {

/// A serial port. Nothing blocks or throws.
class SerialDevice {
 public:
  virtual ~SerialDevice() = default;
  /// At most `size` bytes, 0 when none wait; empty when the port is lost.
  [[nodiscard]] virtual std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) = 0;
  /// False when the port is lost.
  [[nodiscard]] virtual bool write(const std::uint8_t* bytes, std::size_t size) = 0;
};

/// A way to send echo requests to one host. Nothing blocks or throws.
class EchoDevice {
 public:
  struct Reply {
    std::uint16_t sequence;
    Time received;
  };
  virtual ~EchoDevice() = default;
  /// 0, or the errno of a refused request.
  [[nodiscard]] virtual int send(std::uint16_t sequence) = 0;
  /// The next reply; empty when there is none.
  [[nodiscard]] virtual std::optional<Reply> receive() = 0;
};

/// The echo requests of one device.
struct EchoTarget {
  std::string address;            ///< IPv4, dotted
  std::size_t payload_bytes = 0;  ///< a packet has 28 more
  std::uint8_t dscp = 0;          ///< of requests, 0 to 63; replies have the same
};

/// The devices of a simulated computer. A component whose context has them uses them in place of
/// the real ones; it keeps its own code for those. Instead of a descriptor there is `readable`,
/// called when something came; the component passes `schedule().input_arrived()`.
class Devices {
 public:
  using Readable = std::function<void()>;
  virtual ~Devices() = default;
  /// Null when there is no such port.
  [[nodiscard]] virtual std::unique_ptr<SerialDevice> open_serial(const std::string& path,
                                                                  Readable readable) = 0;
  /// Never null.
  [[nodiscard]] virtual std::unique_ptr<EchoDevice> open_echo(const EchoTarget& target,
                                                              Readable readable) = 0;
  /// The text of a device file, as in /proc; empty when there is none.
  [[nodiscard]] virtual std::optional<std::string> read_text(const std::string& path) = 0;
  /// Whether components keep their files for a restart, in the folder of the run; only useful
  /// when processes can crash.
  [[nodiscard]] virtual bool keeps_files() const { return false; }
};

}  // namespace tocsin
