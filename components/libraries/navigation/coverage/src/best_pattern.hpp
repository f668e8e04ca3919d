// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "coverage/floor.hpp"
#include "coverage/swaths.hpp"

namespace tocsin::coverage {

/// What is compared when directions are.
struct Tool {
  double width_m = 0.3;
  double spacing_m = 0.28;
};

/// The floor in cells of swaths: the best of some directions for all, then for each cell another
/// one where that is clearly shorter.
[[nodiscard]] std::vector<SwathCell> decompose(const Floor& floor, const Tool& tool);

}  // namespace tocsin::coverage
