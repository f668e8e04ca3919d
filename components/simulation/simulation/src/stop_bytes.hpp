// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "foundation/stop_value.hpp"

namespace tocsin::simulation {

/// [byte] that a value of the emergency stop adds to a packet of a plain link.
[[nodiscard]] std::size_t stop_bytes(const StopValue& value);

}  // namespace tocsin::simulation
