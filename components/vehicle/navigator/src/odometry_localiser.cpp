// SPDX-License-Identifier: Apache-2.0
#include "navigator/odometry_localiser.hpp"

#include <cmath>

namespace tocsin {

using navigation::Pose2;

namespace {

constexpr double fastest_mps = 0.8;  // a Kobuki drives 0.7 m/s
constexpr double slack_m = 0.2;
constexpr double unknown_gap_s = 5.0;

bool is_at_zero(const Pose2& odom) {
  return std::hypot(odom.x, odom.y) < 0.02 && std::abs(odom.yaw) < 0.05;
}

Pose2 inverse(const Pose2& pose) {
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return {-c * pose.x - s * pose.y, s * pose.x - c * pose.y, -pose.yaw};
}

}  // namespace

std::optional<Pose2> OdometryLocaliser::update(const Pose2& odom, Time now) {
  if (!is_finite(odom)) return std::nullopt;
  if (has_odom_ && has_restarted(odom, now)) {
    const Pose2 last_on_map = compose(memory_.map_from_odom, memory_.odom);
    memory_.map_from_odom = compose(last_on_map, inverse(odom));
  }
  memory_.odom = odom;
  has_odom_ = true;
  last_ = now;
  return compose(memory_.map_from_odom, odom);
}

bool OdometryLocaliser::has_restarted(const Pose2& odom, Time now) const {
  const double gap_s = last_ ? to_seconds(now - *last_) : unknown_gap_s;
  const double moved_m = distance(position(odom), position(memory_.odom));
  const bool began_anew = is_at_zero(odom) && !is_at_zero(memory_.odom) && moved_m > 0.1;
  return began_anew || moved_m > slack_m + fastest_mps * gap_s;
}

}  // namespace tocsin
