// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin {

/// Sets a terminal to any speed [Bd], also one without a constant of its own. False when it cannot.
[[nodiscard]] bool set_line_speed(int descriptor, unsigned baud);

}  // namespace tocsin
