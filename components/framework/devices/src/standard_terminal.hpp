// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "devices/terminal_device.hpp"

namespace tocsin {

/// Standard input and output of this process, see Devices::open_terminal.
[[nodiscard]] std::unique_ptr<TerminalDevice> open_standard_terminal();

}  // namespace tocsin
