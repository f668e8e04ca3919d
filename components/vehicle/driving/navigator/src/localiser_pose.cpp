// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_pose.hpp"

#include <cmath>

namespace tocsin {
namespace {

constexpr double most_deviation_m = 0.5;
constexpr double most_step_m = 0.5;  // of odometry from message to message

}  // namespace

void LocaliserPose::on_odometry(std::int64_t stamp_ns, const geometry::Pose& odom) {
  if (!is_finite(odom)) return;
  const bool has_jumped = odom_ && distance(position(*odom_), position(odom)) > most_step_m;
  if (has_jumped) {  // a driver that began anew
    odometry_.clear();
    sure_.reset();
  }
  odometry_.add(stamp_ns, odom);
  odom_ = odom;
}

void LocaliserPose::on_localiser(std::int64_t stamp_ns, const geometry::Pose& pose,
                                 double deviation_m, Time now) {
  if (!is_finite(pose) || !(deviation_m <= most_deviation_m)) return sure_.reset();
  const auto odom = odometry_.at(stamp_ns);
  if (!odom) return;
  map_from_odom_ = compose(pose, inverse(*odom));
  sure_ = now;
}

std::optional<geometry::Pose> LocaliserPose::pose(Time now) const {
  if (!odom_ || !sure_ || now - *sure_ > timeout_) return std::nullopt;
  return compose(map_from_odom_, *odom_);
}

}  // namespace tocsin
