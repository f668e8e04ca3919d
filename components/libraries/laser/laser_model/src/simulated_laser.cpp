// SPDX-License-Identifier: Apache-2.0
#include "laser_model/simulated_laser.hpp"

#include <cmath>
#include <utility>

namespace tocsin::laser {
namespace {

rplidar::ModelParams params_of(const LaserProfile& profile) {
  rplidar::ModelParams params;
  params.model = profile.motor_by_request ? 0x28 : 0x18;
  params.turn_hz = profile.turn_hz;
  params.readings_per_s = profile.readings_per_s;
  params.motor_by_request = profile.motor_by_request;
  return params;
}

}  // namespace

SimulatedLaser::SimulatedLaser(const LaserProfile& profile, std::shared_ptr<const Scene> scene,
                               const geometry::Pose& mount, std::uint64_t seed, Time now)
    : scene_(std::move(scene)),
      mount_(mount),
      model_(profile, seed),
      motion_time_(now),
      device_(
          params_of(profile), [this](double bearing, Time at) { return look(bearing, at); }, now) {}

void SimulatedLaser::step(const Motion& motion, Time now, const rplidar::RplidarModel::Sink& sink) {
  motion_ = motion;
  motion_time_ = now;
  device_.step(now, sink);
}

rplidar::RplidarModel::Look SimulatedLaser::look(double bearing_rad, Time at) {
  if (is_covered_ && bearing_rad > 0) return {0, 0};
  const double share = geometry::wrap_angle(bearing_rad) / (2 * pi) + 0.5;
  const auto bin = static_cast<std::size_t>(share * static_cast<double>(last_turn_m_.size()));
  double& last_m = last_turn_m_[bin % last_turn_m_.size()];
  if (!is_stuck_) last_m = measure(bearing_rad, at);
  return {last_m, 47};
}

/// The vehicle was on an arc since then. 0: no return.
double SimulatedLaser::measure(double bearing_rad, Time at) {
  const double dt_s = to_seconds(at - motion_time_);
  const double turn_rad = motion_.velocity.angular_rad_s * dt_s;
  const double way_m = motion_.velocity.linear_mps * dt_s;
  const geometry::Pose since{way_m * std::cos(turn_rad / 2), way_m * std::sin(turn_rad / 2),
                             turn_rad};
  const geometry::Pose laser = compose(compose(motion_.pose, since), mount_);
  const double range_m = model_.range(*scene_, laser, bearing_rad);
  return std::isfinite(range_m) ? range_m : 0;
}

}  // namespace tocsin::laser
