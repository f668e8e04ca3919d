// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "devices/device.hpp"

namespace tocsin {

/// A serial port: 115200 baud, 8N1, raw. Nothing blocks or throws.
class SerialDevice : public Device {
 public:
  /// At most `size` bytes, 0 when none wait; empty when the port is lost.
  [[nodiscard]] virtual std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) = 0;
  /// False when the port is lost; bytes that do not fit are dropped.
  [[nodiscard]] virtual bool write(const std::uint8_t* bytes, std::size_t size) = 0;
};

/// What came of opening a serial port.
struct OpenedSerial {
  enum class Result { open, absent, busy };
  Result result = Result::absent;
  std::unique_ptr<SerialDevice> port;  ///< null unless open
  std::string reason;                  ///< one line, for people
  /// Whether a living process holds a busy port, as far as we may see.
  bool held = false;
};

}  // namespace tocsin
