// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "devices/device.hpp"

namespace tocsin {

/// The terminal of this process: keys without echo and without waiting for Enter, as before again
/// when it is destroyed; without a terminal standard input as it is. Nothing blocks or throws.
class TerminalDevice : public Device {
 public:
  static constexpr const char* kind = "terminal";
  /// The bytes that wait; empty when nothing can come any more.
  [[nodiscard]] virtual std::optional<std::string> read() { return std::nullopt; }
  /// Text that stays.
  virtual void print(const std::string& /*text*/) {}
  /// A line that the next one replaces.
  virtual void show(const std::string& /*line*/) {}
};

}  // namespace tocsin
