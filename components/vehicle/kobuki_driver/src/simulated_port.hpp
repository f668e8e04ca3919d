// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_driver/byte_port.hpp"
#include "runtime/devices.hpp"

namespace tocsin::kobuki {

/// Opens a port of a simulated computer; `readable` is called when bytes came.
[[nodiscard]] Opened open_simulated_port(Devices& devices, const std::string& path,
                                         Devices::Readable readable);

}  // namespace tocsin::kobuki
