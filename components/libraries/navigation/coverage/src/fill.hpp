// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "best_pattern.hpp"
#include "coverage/covered_floor.hpp"

namespace tocsin::coverage {

/// Single swaths for what the cells leave out beside walls, where one is worth its way: at least
/// `least_share` of it covers something new. Drives them over `covered`.
[[nodiscard]] std::vector<SwathCell> fill_gaps(const Mask& centres, const Tool& tool,
                                               double least_share, CoveredFloor& covered);

}  // namespace tocsin::coverage
