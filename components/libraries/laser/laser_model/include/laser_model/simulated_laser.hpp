// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "laser_model/laser_model.hpp"
#include "rplidar_protocol/rplidar_model.hpp"

namespace tocsin::laser {

/// A laser on a simulated vehicle, behind the protocol of an RPLIDAR. Pure; `now` must not
/// decrease.
class SimulatedLaser {
 public:
  /// How the vehicle is and moves, at the time of the last step.
  struct Motion {
    geometry::Pose pose;  ///< map frame
    geometry::Twist velocity;
  };

  /// `mount`: of the laser on the vehicle. The scene is looked at, and moved, by whoever owns it.
  SimulatedLaser(const LaserProfile& profile, std::shared_ptr<const Scene> scene,
                 const geometry::Pose& mount, std::uint64_t seed, Time now);
  SimulatedLaser(const SimulatedLaser&) = delete;
  SimulatedLaser& operator=(const SimulatedLaser&) = delete;

  void receive(ByteView bytes, Time now) { device_.receive(bytes, now); }
  /// Hands over what the device has sent until `now`, where the vehicle moves like this.
  void step(const Motion& motion, Time now, const rplidar::RplidarModel::Sink& sink);
  [[nodiscard]] Time next_event() const { return device_.next_event(); }

  /// Something hangs over the left half of it, which then measures nothing.
  void cover(bool half) { is_covered_ = half; }
  /// It repeats what it measured in its last turn.
  void stick(bool stuck) { is_stuck_ = stuck; }
  [[nodiscard]] rplidar::RplidarModel& device() { return device_; }

 private:
  [[nodiscard]] rplidar::RplidarModel::Look look(double bearing_rad, Time at);
  [[nodiscard]] double measure(double bearing_rad, Time at);

  std::shared_ptr<const Scene> scene_;
  geometry::Pose mount_;
  LaserModel model_;
  Motion motion_;
  Time motion_time_;
  bool is_covered_ = false;
  bool is_stuck_ = false;
  std::array<double, 360> last_turn_m_{};  ///< by bearing, from 0 to the left
  rplidar::RplidarModel device_;
};

}  // namespace tocsin::laser
