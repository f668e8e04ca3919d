// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "laser_geometry/scan.hpp"

namespace tocsin {

/// How a vehicle that does not know where it is moves, so that a localiser may find out: it stands
/// for 3 s, turns on the spot for 30 s, and then drives, for 10 s, where its laser sees the way
/// ahead free for a metre, and turns where it does not. Then the same again.
///
/// Pure; `now` must not decrease.
class LookAround {
 public:
  /// A turn of the laser, in the frame of the vehicle.
  void on_scan(const laser::Scan& scan, Time now);
  /// It knows where it is, or has nothing to look for.
  void end() { since_.reset(); }
  /// The velocity that is wanted now. Begins with the first call.
  [[nodiscard]] geometry::Twist next(Time now);

 private:
  [[nodiscard]] bool is_free_ahead(Time now) const;
  std::optional<Time> since_;
  std::optional<Time> seen_;
  double free_m_ = 0;  ///< ahead of the vehicle's middle, at the last scan
  bool is_driving_ = false;
};

}  // namespace tocsin
