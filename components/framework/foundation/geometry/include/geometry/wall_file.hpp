// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/wall.hpp"

namespace tocsin::geometry {

/// Reads `walls: [[x1, y1, x2, y2, loss_db], ...]` [m, dB]; the list may be empty. What has been
/// read is kept until the file changes. Any thread. Throws ConfigError with file and line when the
/// file is not of this form, a number is not finite, or a loss is outside [0, 100].
[[nodiscard]] std::vector<Wall> load_walls(const std::string& path);

}  // namespace tocsin::geometry
