// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "coverage/swaths.hpp"
#include "navigation/cost_map.hpp"

namespace tocsin::coverage {

/// The cells in an order with short ways between them, each with its swaths in the order and the
/// direction of the drive. The nearest one first, then exchanged until nothing is won; with more
/// than 150 cells, the nearest one each time. Ways are those over the cost map.
[[nodiscard]] std::vector<SwathCell> order_cells(const std::vector<SwathCell>& cells,
                                                 const navigation::CostMap& costs,
                                                 const geometry::Point& start);

}  // namespace tocsin::coverage
