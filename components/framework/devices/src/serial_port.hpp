// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "devices/serial_device.hpp"

namespace tocsin {

/// Opens a serial device for ourselves alone: 115200 baud, raw, low latency where the hardware can,
/// with TIOCEXCL and both kinds of file lock (the reference driver of ROS uses one of them). What
/// was waiting in it is discarded. Does not block.
[[nodiscard]] OpenedSerial open_serial_port(const std::string& path);

}  // namespace tocsin
