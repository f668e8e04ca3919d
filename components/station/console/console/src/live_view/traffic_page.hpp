// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "live_view/screen.hpp"

namespace tocsin::view {

/// The topics that carry nothing behind the others, each in their order: what has room at the top
/// are those that matter.
[[nodiscard]] std::vector<TrafficRow> idle_last(std::vector<TrafficRow> traffic);

/// The topics of the vehicle as a table, its head first, at most `width` columns wide.
[[nodiscard]] std::vector<terminal::Line> traffic_lines(const std::vector<TrafficRow>& traffic,
                                                        const FreshnessLimits& limits,
                                                        std::size_t width);

}  // namespace tocsin::view
