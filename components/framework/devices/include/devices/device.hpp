// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tocsin {

/// Something of the computer that bytes, events or replies come from. Used by one thread.
class Device {
 public:
  virtual ~Device() = default;
  /// Readable when something waits or the device is gone; the device keeps it. Empty when there is
  /// nothing to poll, as in simulated time: then `readable`, given at opening, is called instead.
  [[nodiscard]] virtual std::optional<int> descriptor() const { return std::nullopt; }
};

}  // namespace tocsin
