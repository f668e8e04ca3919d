// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::coverage {

inline constexpr std::size_t most_corners = 1000;  ///< of a polygon

/// Throws ConfigError naming `what`, the corner and what is allowed when it is none: fewer than 3
/// or more than most_corners corners, one that is not finite, sides that cross or touch.
void require_polygon(const std::vector<geometry::Point>& corners, const char* what);

/// Whether `p` is inside (even-odd rule).
[[nodiscard]] bool is_inside(const std::vector<geometry::Point>& corners, const geometry::Point& p);

}  // namespace tocsin::coverage
