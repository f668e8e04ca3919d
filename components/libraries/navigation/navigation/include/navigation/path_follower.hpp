// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "foundation/numbers.hpp"
#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"

namespace tocsin::navigation {

/// How a path is driven. The defaults suit a Kobuki base (at most 0.7 m/s and 110 deg/s).
struct FollowerParams {
  double speed_mps = 0.5;
  double turn_rate_radps = 1.2;
  double acceleration_mps2 = 0.5;
  double turn_acceleration_radps2 = 3.0;
  double creep_mps = 0.06;
  double lookahead_m = 0.4;
  double turn_in_place_rad = 0.9;
  double turn_done_rad = 0.25;
  template <class Visitor>
  void visit(Visitor& v) {
    live(v)("speed_mps", speed_mps, {0.05, 0.7}, "[m/s] top speed");
    live(v)("turn_rate_radps", turn_rate_radps, {0.1, 3}, "[rad/s] top turn rate");
    v("acceleration_mps2", acceleration_mps2, {0.05, 3}, "[m/s^2] limit, also for braking");
    v("turn_acceleration_radps2", turn_acceleration_radps2, {0.1, 20}, "[rad/s^2] limit");
    v("creep_mps", creep_mps, {0.01, 0.2}, "[m/s] lowest speed on the last centimetres");
    v("lookahead_m", lookahead_m, {0.1, 2}, "[m] distance of the point that is steered to");
    v("turn_in_place_rad", turn_in_place_rad, {0.3, 3}, "[rad] larger heading error: turn first");
    v("turn_done_rad", turn_done_rad, {0.05, 1}, "[rad] smaller heading error: drive again");
  }
};

/// Drives a path by pure pursuit: steers on an arc to the point `lookahead_m` ahead on the path
/// (Coulter 1992, CMU-RI-TR-92-01), slows before the end and in turns, turns in place when the
/// heading is far off.
///
/// Pure. It remembers the path, how far along it the robot is, and the last velocity, so that no
/// command jumps by more than the acceleration limits.
class PathFollower {
 public:
  /// Throws ConfigError when `turn_done_rad` is not below `turn_in_place_rad`.
  explicit PathFollower(const FollowerParams& params);
  /// Other top speeds from now on, reached within the acceleration limits.
  void set_speeds(double speed_mps, double turn_rate_radps);

  /// Replaces the path; the velocity goes on from where it is. The path must not be empty.
  void start(geometry::Path path);

  /// The velocity for the next instant, `dt` after the last one, reached within the limits at most
  /// `most_mps`. Asserts that there is a path.
  [[nodiscard]] geometry::Twist follow(const geometry::Pose& pose, Duration dt,
                                       double most_mps = infinity);
  /// Turns on the spot towards the heading `yaw_rad`.
  [[nodiscard]] geometry::Twist turn_to(const geometry::Pose& pose, double yaw_rad, Duration dt);
  /// Drives without a path, at a velocity that is reached within the limits.
  [[nodiscard]] geometry::Twist move_at(const geometry::Twist& velocity, Duration dt);
  /// Brakes within the limits.
  [[nodiscard]] geometry::Twist brake(Duration dt);
  /// Backs up slowly and straight.
  [[nodiscard]] geometry::Twist back_up(Duration dt);
  /// Stands at once, limits ignored: for emergencies.
  [[nodiscard]] geometry::Twist halt();

  [[nodiscard]] const geometry::Path& path() const { return path_; }
  /// What of the path lies ahead of a robot there.
  [[nodiscard]] geometry::Path rest(const geometry::Point& from) const;
  [[nodiscard]] geometry::Twist velocity() const { return velocity_; }
  /// How far there is to go along the path [m], and how far the robot is beside it [m].
  /// Both as of the last `follow`.
  [[nodiscard]] double remaining_m() const { return remaining_m_; }
  [[nodiscard]] double deviation_m() const { return deviation_m_; }

 private:
  void advance(const geometry::Point& p);
  /// Of the part of the path from its corner `i` to the next one.
  [[nodiscard]] double length_m(std::size_t i) const { return to_end_m_[i] - to_end_m_[i + 1]; }
  [[nodiscard]] geometry::Point point_ahead(double ahead_m) const;
  [[nodiscard]] geometry::Twist pursue(const geometry::Pose& pose, double most_mps);
  [[nodiscard]] geometry::Twist turn(double error_rad) const;
  geometry::Twist limited(const geometry::Twist& wanted, Duration dt);

  FollowerParams params_;
  geometry::Path path_;
  std::vector<double> to_end_m_;  // along the path, from each corner
  std::size_t segment_ = 0;       // the robot is beside path_[segment_] .. path_[segment_ + 1]
  double share_ = 0;              // of that segment that lies behind the robot
  double remaining_m_ = 0;
  double deviation_m_ = 0;
  bool turning_ = false;
  geometry::Twist velocity_;
};

}  // namespace tocsin::navigation
