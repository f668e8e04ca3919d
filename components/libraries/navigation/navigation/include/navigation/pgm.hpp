// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tocsin::navigation {

/// A grey image, row by row from the top.
struct GrayImage {
  int width = 0;
  int height = 0;
  int max = 255;  // the value of white
  std::vector<std::uint8_t> pixels;
};

/// Reads a PGM image, binary (P5) or text (P2), with at most 8 bits and 25 million pixels.
/// Throws ConfigError naming `file` when the bytes are something else, or too few.
[[nodiscard]] GrayImage parse_pgm(const std::string& bytes, const std::string& file);

}  // namespace tocsin::navigation
