// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "devices/gamepad_device.hpp"

namespace tocsin {

/// By libevdev: the gamepad of a path, or with an empty one the first in /dev/input. Null: none.
[[nodiscard]] std::unique_ptr<GamepadDevice> open_evdev_gamepad(const std::string& path);

}  // namespace tocsin
