// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "teleop_gamepad/gamepad_teleop.hpp"

namespace tocsin {

/// A gamepad that is plugged in. Nothing blocks or throws.
class GamepadPort {
 public:
  enum class Read { event, nothing, lost };
  virtual ~GamepadPort() = default;
  /// Readable when events wait or the pad is gone; -1 when there is nothing to poll.
  [[nodiscard]] virtual int descriptor() const = 0;
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual PadAxes axes() const = 0;
  [[nodiscard]] virtual Read read(PadEvent& event) = 0;
};

/// Opens the gamepad of a device path, or with an empty one the first there is. Null: none.
using GamepadOpener = std::function<std::unique_ptr<GamepadPort>(const std::string& path)>;

/// By libevdev; looks through /dev/input.
[[nodiscard]] std::unique_ptr<GamepadPort> open_evdev_gamepad(const std::string& path);

}  // namespace tocsin
