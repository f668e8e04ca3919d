// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_pose.hpp"

#include <cmath>

namespace tocsin {
namespace {

constexpr double most_deviation_m = 0.5;
constexpr double most_step_m = 0.5;  // of odometry from message to message
/// A localiser that has moved less than that, where odometry has moved by more, is stuck: or the
/// wheels turn in vain.
constexpr double unmoved_m = 0.1;
constexpr double moved_m = 0.6;

}  // namespace

void LocaliserPose::on_odometry(std::int64_t stamp_ns, const geometry::Pose& odom) {
  if (!is_finite(odom)) return;
  const bool has_jumped = odom_ && distance(position(*odom_), position(odom)) > most_step_m;
  if (has_jumped) {  // a driver that began anew
    odometry_.clear();
    sure_.reset();
    before_.reset();
  }
  odometry_.add(stamp_ns, odom);
  odom_ = odom;
}

void LocaliserPose::on_localiser(std::int64_t stamp_ns, const geometry::Pose& pose,
                                 double deviation_m, Time now) {
  if (!is_finite(pose) || !(deviation_m <= most_deviation_m)) return sure_.reset();
  const auto odom = odometry_.at(stamp_ns);
  if (!odom) return;
  if (is_stuck(pose, *odom, now)) return sure_.reset();
  map_from_odom_ = compose(pose, inverse(*odom));
  sure_ = now;
}

/// For as long as its timeout: a vehicle that stands cannot find out more.
bool LocaliserPose::is_stuck(const geometry::Pose& pose, const geometry::Pose& odom, Time now) {
  if (!before_) before_ = Both{pose, odom};
  if (distance(position(before_->odom), position(odom)) > moved_m) {
    const bool has_moved = distance(position(before_->pose), position(pose)) > unmoved_m;
    if (!has_moved) stuck_until_ = now + timeout_;
    before_ = Both{pose, odom};
  }
  return now < stuck_until_;
}

std::optional<geometry::Pose> LocaliserPose::pose(Time now) const {
  if (!odom_ || !sure_ || now - *sure_ > timeout_) return std::nullopt;
  return compose(map_from_odom_, *odom_);
}

}  // namespace tocsin
