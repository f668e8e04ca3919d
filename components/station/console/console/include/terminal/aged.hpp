// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/freshness.hpp"
#include "terminal/line.hpp"

namespace tocsin::terminal {

/// `words` about a value as they may be shown at its age: as they are while it is fresh, grey and
/// with the age when it is stale. Of an unknown value only its age is left. Pure.
[[nodiscard]] Line aged(Line words, Duration age, const FreshnessLimits& limits = {});

}  // namespace tocsin::terminal
