// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "devices/device.hpp"

namespace tocsin {

/// A serial port for ourselves alone: 8N1, raw, 115200 baud at first. What was waiting in it is
/// discarded at opening. Nothing blocks or throws.
class SerialDevice : public Device {
 public:
  static constexpr const char* kind = "serial port";
  /// At most `size` bytes, 0 when none wait; empty when the port is lost.
  [[nodiscard]] virtual std::optional<std::size_t> read(std::uint8_t* /*to*/,
                                                        std::size_t /*size*/) {
    return 0;
  }
  /// Another speed [Bd] from now on. False when the port cannot.
  [[nodiscard]] virtual bool set_speed(unsigned /*baud*/) { return true; }
  /// The line "data terminal ready". False when the port has none, as a pseudo-terminal.
  [[nodiscard]] virtual bool set_dtr(bool /*on*/) { return false; }
  /// False when the port is lost; bytes that do not fit are dropped.
  [[nodiscard]] virtual bool write(const std::uint8_t* /*bytes*/, std::size_t /*size*/) {
    return true;
  }
};

using OpenedSerial = Opened<SerialDevice>;

}  // namespace tocsin
