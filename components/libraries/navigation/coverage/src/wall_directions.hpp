// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "coverage/mask.hpp"

namespace tocsin::coverage {

/// The directions in which most of a mask's edge runs [rad] [range 0,pi), the longest first; at
/// most `most`. Each is a mean over the straight pieces of the edge, to about a tenth of a degree.
[[nodiscard]] std::vector<double> wall_directions(const Mask& mask, std::size_t most);

/// The direction in which points spread most [rad] [range -pi/2,pi/2].
[[nodiscard]] double long_axis(const std::vector<geometry::Point>& points);

}  // namespace tocsin::coverage
