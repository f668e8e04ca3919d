// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "laser_model/scene.hpp"

namespace tocsin::laser {

/// Reads what stands and walks around but is on no map:
///
///     boxes: [[x, y, length, width, heading_rad], ...]   # [m]
///     discs: [[x, y, radius], ...]
///     walkers:
///       - {way: [[x, y], ...], speed_mps: 0.8, pause_s: 1, radius_m: 0.2}
///
/// Each list may be absent. Throws ConfigError that names the file, the line, the value and what is
/// allowed.
[[nodiscard]] Obstacles load_obstacles(const std::string& path);

}  // namespace tocsin::laser
