// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "devices/device.hpp"

namespace tocsin {

/// Where keys come from and lines go to. Nothing blocks or throws.
class TerminalDevice : public Device {
 public:
  /// The bytes that wait; empty when nothing can come any more.
  [[nodiscard]] virtual std::optional<std::string> read() = 0;
  /// Text that stays.
  virtual void print(const std::string& text) = 0;
  /// A line that the next one replaces.
  virtual void show(const std::string& line) = 0;
};

}  // namespace tocsin
