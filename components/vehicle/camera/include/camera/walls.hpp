// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::camera {

/// Something upright that stands on the floor, seen from above as a line. Map frame.
struct Wall {
  double x1_m = 0;
  double y1_m = 0;
  double x2_m = 0;
  double y2_m = 0;
  bool is_furniture = false;  ///< lower than a wall: one can look over it
};

/// Reads `walls: [[x1, y1, x2, y2, loss_db], ...]`. A loss of 0 dB marks furniture, which is below
/// the antennas. Throws ConfigError with file and line when the file is not of this form.
[[nodiscard]] std::vector<Wall> load_walls(const std::string& path);

}  // namespace tocsin::camera
