// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "geometry/pose.hpp"

namespace tocsin::foxglove {

/// Where the access point of a run's emulated radio stands, in the map's frame, by the deployment
/// that the launcher has left in the run's folder; none: the run has no radio, or its channel knows
/// no places.
[[nodiscard]] std::optional<geometry::Point> access_point_of(const std::string& run_dir);

}  // namespace tocsin::foxglove
