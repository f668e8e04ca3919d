// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::mapping {

/// Where the vehicle was between two places that are known. `odometry` are the readings on the way,
/// that of the first and of the last place among them (at least two). What the odometry got wrong
/// is spread over the way: a metre is taken to be as uncertain as a radian of turning; headings
/// first, then the places that the corrected headings lead to.
[[nodiscard]] std::vector<geometry::Pose> spread_misfit(const std::vector<geometry::Pose>& odometry,
                                                        const geometry::Pose& first,
                                                        const geometry::Pose& last);

}  // namespace tocsin::mapping
