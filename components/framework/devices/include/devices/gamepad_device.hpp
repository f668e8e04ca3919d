// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "devices/device.hpp"

namespace tocsin {

/// One event of the kernel's input layer; the numbers are those of linux/input-event-codes.h.
struct PadEvent {
  std::uint16_t type = 0;
  std::uint16_t code = 0;
  std::int32_t value = 0;
};

/// What an axis can say.
struct PadAxis {
  std::int32_t min = 0;
  std::int32_t max = 255;
};
using PadAxes = std::map<std::uint16_t, PadAxis>;  ///< by code

/// A gamepad that is plugged in; that of an empty path is the first there is. Nothing blocks or
/// throws.
class GamepadDevice : public Device {
 public:
  static constexpr const char* kind = "gamepad";
  enum class Read { event, nothing, lost };
  [[nodiscard]] virtual std::string name() const { return {}; }
  [[nodiscard]] virtual PadAxes axes() const { return {}; }
  [[nodiscard]] virtual Read read(PadEvent& /*event*/) { return Read::nothing; }
};

}  // namespace tocsin
