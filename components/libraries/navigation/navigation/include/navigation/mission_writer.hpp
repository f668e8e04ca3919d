// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "navigation/mission.hpp"

namespace tocsin::navigation {

/// A mission as the YAML text that load_mission reads, to 0.1 mm.
[[nodiscard]] std::string mission_text(const Mission& mission);

/// Writes that file, replaced in one step. Throws ConfigError when it cannot be written, or when
/// the mission has none or more than most_waypoints.
void write_mission(const Mission& mission, const std::string& path);

}  // namespace tocsin::navigation
