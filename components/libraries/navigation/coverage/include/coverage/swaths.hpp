// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "coverage/mask.hpp"

namespace tocsin::coverage {

/// A straight piece of the drive.
struct Swath {
  geometry::Point from;
  geometry::Point to;
};
[[nodiscard]] double length_m(const Swath& swath);

/// Swaths side by side, each next to the one before, all in the same direction: a cell that is
/// driven to and fro.
using SwathCell = std::vector<Swath>;
[[nodiscard]] std::size_t swaths_in(const std::vector<SwathCell>& cells);

/// Parallel lines over the plane.
struct Pattern {
  double direction_rad = 0;
  double spacing_m = 0.3;
  double first_m = 0;  ///< of the first line, from the side of the mask
};

/// A pattern whose first and last line are `inset_m` within the sides of the mask, the others not
/// farther apart than `spacing_m`.
[[nodiscard]] Pattern fitted(const Mask& mask, const Pattern& pattern, double inset_m);

/// Boustrophedon decomposition (Choset 2000): the pieces of the lines that are within the mask,
/// divided into cells wherever pieces of neighbouring lines split, join, begin or end.
/// A line that only touches the mask gives a swath of length 0.
[[nodiscard]] std::vector<SwathCell> swath_cells(const Mask& mask, const Pattern& pattern);

}  // namespace tocsin::coverage
