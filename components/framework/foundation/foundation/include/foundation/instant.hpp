// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "foundation/time.hpp"

namespace tocsin {

/// One moment on both clocks of a host.
struct Instant {
  Time now{};
  std::int64_t wall_ns = 0;  ///< [ns] since the Unix epoch
};

}  // namespace tocsin
