// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::geometry {

/// A velocity in the plane of a vehicle that cannot move sideways: of its centre forwards, and of
/// its heading, counter-clockwise seen from above.
struct Twist {
  double linear_mps = 0;
  double angular_rad_s = 0;
};

}  // namespace tocsin::geometry
