// SPDX-License-Identifier: Apache-2.0
#include "navigator/odometry_localiser.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin {

namespace {

constexpr double fastest_mps = 0.8;  // a Kobuki drives 0.7 m/s
constexpr double slack_m = 0.2;
constexpr double unknown_gap_s = 5.0;
/// What was driven in a longer gap may come later than the first pose after it, in one step: a
/// process stood still, and its poses come in a burst.
constexpr double short_gap_s = 0.1;
constexpr Duration burst_lasts = std::chrono::seconds(1);

bool is_at_zero(const geometry::Pose& odom) {
  return std::hypot(odom.x_m, odom.y_m) < 0.02 && std::abs(odom.heading_rad) < 0.05;
}

}  // namespace

std::optional<geometry::Pose> OdometryLocaliser::update(const geometry::Pose& odom, Time now) {
  if (!is_finite(odom)) return std::nullopt;
  if (has_odom_ && has_restarted(odom, now)) {
    const geometry::Pose last_on_map = compose(memory_.map_from_odom, memory_.odom);
    memory_.map_from_odom = compose(last_on_map, inverse(odom));
  }
  note_gap(distance(position(odom), position(memory_.odom)), now);
  memory_.odom = odom;
  has_odom_ = true;
  last_ = now;
  return compose(memory_.map_from_odom, odom);
}

void OdometryLocaliser::note_gap(double moved_m, Time now) {
  if (now - gap_ended_ > burst_lasts) recent_gap_s_ = 0;
  const double gap_s = last_ ? to_seconds(now - *last_) : 0;
  if (gap_s > short_gap_s) {
    recent_gap_s_ += gap_s;
    gap_ended_ = now;
  }
  recent_gap_s_ = std::max(recent_gap_s_ - moved_m / fastest_mps, 0.0);
}

bool OdometryLocaliser::has_restarted(const geometry::Pose& odom, Time now) const {
  const double before_s = now - gap_ended_ <= burst_lasts ? recent_gap_s_ : 0;
  const double gap_s = before_s + (last_ ? to_seconds(now - *last_) : unknown_gap_s);
  const double moved_m = distance(position(odom), position(memory_.odom));
  const bool began_anew = is_at_zero(odom) && !is_at_zero(memory_.odom) && moved_m > 0.1;
  return began_anew || moved_m > slack_m + fastest_mps * gap_s;
}

}  // namespace tocsin
