// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tocsin::camera {

/// Red, green, blue; one byte each, rows from the top, no padding.
struct Picture {
  Picture(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        rgb(3 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {}

  /// The first of the three bytes of a pixel.
  [[nodiscard]] std::uint8_t* at(int column, int row) {
    return &rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(column))];
  }
  [[nodiscard]] const std::uint8_t* at(int column, int row) const {
    return const_cast<Picture*>(this)->at(column, row);
  }

  int width;
  int height;
  std::vector<std::uint8_t> rgb;
};

}  // namespace tocsin::camera
