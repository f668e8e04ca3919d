// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "kobuki_model/surroundings.hpp"
#include "kobuki_protocol/odometry.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::kobuki {

/// The round body among obstacles: where it is, what it touches, and what stops it.
/// Pure; the pose is the truth in the map frame.
class Body {
 public:
  Body(Surroundings surroundings, const geometry::Pose& start);
  /// The longest `dt` of a move: in a longer one a body would stop too far from an obstacle to
  /// press its bumper. Far from everything that does not matter.
  [[nodiscard]] Duration longest_move() const;
  /// Moves for `dt` with the velocity on an arc, unless that ends in an obstacle: then it only
  /// turns. Returns the velocity it really had.
  geometry::Twist move(const geometry::Twist& wanted, double dt_s);
  void place(const geometry::Pose& pose) { pose_ = pose; }
  /// Something in the surroundings is elsewhere now.
  void surroundings_moved() { look_.reset(); }

  [[nodiscard]] const geometry::Pose& pose() const { return pose_; }
  /// Bumper bits of core sensors: contacts within 90 degrees ahead, in sectors of 60 degrees.
  [[nodiscard]] std::uint8_t bumper() const;
  /// Whether the last move was stopped by an obstacle.
  [[nodiscard]] bool blocked() const { return blocked_; }

 private:
  /// Whether nothing is within reach of a body there.
  [[nodiscard]] bool is_clear(double x_m, double y_m) const;
  [[nodiscard]] bool goes_into(double x_m, double y_m, double direction_rad) const;
  Surroundings surroundings_;
  /// Where walls were last looked for, and whether there was none within reach and some way more.
  struct Look {
    double x_m;
    double y_m;
    bool clear;
    [[nodiscard]] bool is_over(double now_x_m, double now_y_m) const;
  };
  mutable std::optional<Look> look_;
  geometry::Pose pose_;
  bool blocked_ = false;
};

/// The bumper bit of a contact at `bearing` from straight ahead, counter-clockwise positive; 0
/// behind.
[[nodiscard]] std::uint8_t bumper_bit(double bearing_rad);

}  // namespace tocsin::kobuki
